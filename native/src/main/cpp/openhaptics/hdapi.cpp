#include "openhaptics/hdapi.h"

#include <vector>

#include "device/library.h"

namespace palpate::openhaptics {
namespace {

std::vector<std::string> names() {
#if defined(_WIN32)
  return {"HD.dll"};
#elif defined(__APPLE__)
  return {"/Library/Frameworks/OpenHaptics.framework/OpenHaptics"};
#else
  return {"libHD.so.3", "libHD.so"};
#endif
}

}  // namespace

HdApi& HdApi::instance() {
  static auto* api = new HdApi();  // never destroyed, because a servo thread may hang in it
  return *api;
}

HdApi::HdApi() {
  const Wanted wanted{names(), nullptr, "OpenHaptics",
                      "install the device driver and OpenHaptics from 3D Systems",
                      "install OpenHaptics 3 or newer"};
  findFunctions(wanted, *this, [this](Library& found) {
    found.need("hdInitDevice", initDevice);
    found.need("hdMakeCurrentDevice", makeCurrentDevice);
    found.need("hdDisableDevice", disableDevice);
    found.need("hdBeginFrame", beginFrame);
    found.need("hdEndFrame", endFrame);
    found.need("hdGetError", getError);
    found.need("hdGetErrorString", getErrorString);
    found.need("hdEnable", enable);
    found.need("hdGetBooleanv", getBooleanv);
    found.need("hdGetIntegerv", getIntegerv);
    found.need("hdGetDoublev", getDoublev);
    found.need("hdGetString", getString);
    found.need("hdSetDoublev", setDoublev);
    found.need("hdCheckCalibration", checkCalibration);
    found.need("hdCheckCalibrationStyle", checkCalibrationStyle);
    found.need("hdUpdateCalibration", updateCalibration);
    found.need("hdStartScheduler", startScheduler);
    found.need("hdStopScheduler", stopScheduler);
    found.need("hdScheduleAsynchronous", scheduleAsynchronous);
    found.need("hdUnschedule", unschedule);
  });
}

}  // namespace palpate::openhaptics
