#include "forcedimension/dhd.h"

#include <vector>

#include "device/library.h"

namespace palpate::forcedimension {
namespace {

std::vector<std::string> names() {
#if defined(_WIN32)
  return {"dhd64.dll", "drd64.dll"};
#elif defined(__APPLE__)
  return {"libdhd.3.dylib", "libdhd.dylib", "libdrd.dylib"};
#else
  return {"libdhd.so.3", "libdhd.so", "libdrd.so.3", "libdrd.so"};
#endif
}

}  // namespace

Dhd& Dhd::instance() {
  static auto* api = new Dhd();  // outlives a thread that hangs in it
  return *api;
}

Dhd::Dhd() {
  const Wanted wanted{names(), "FDSDK", "Force Dimension's SDK",
                      "install it and let FDSDK name the folder of its library",
                      "install version 3 of the SDK"};
  findFunctions(wanted, *this, [this](Library& found) {
    found.need("dhdGetDeviceCount", getDeviceCount);
    found.need("dhdOpen", open);
    found.need("dhdOpenSerial", openSerial);
    found.need("dhdClose", close);
    found.need("dhdStop", stop);
    found.need("dhdEnableForce", enableForce);
    found.need("dhdGetSystemType", getSystemType);
    found.need("dhdGetSystemName", getSystemName);
    found.need("dhdGetSerialNumber", getSerialNumber);
    found.need("dhdGetPosition", getPosition);
    found.need("dhdGetPositionAndOrientationFrame", getPositionAndFrame);
    found.need("dhdGetButtonMask", getButtonMask);
    found.need("dhdSetForceAndTorque", setForceAndTorque);
    found.need("dhdGetStatus", getStatus);
    found.need("dhdHasWrist", hasWrist);
    found.need("dhdHasActiveWrist", hasActiveWrist);
    found.need("dhdErrorGetLastStr", errorGetLastStr);
    found.wish("dhdEnableExpertMode", enableExpertMode);
    found.wish("dhdSetWatchdog", setWatchdog);
  });
}

std::string Dhd::lastError() const {
  const char* text = errorGetLastStr();
  return text != nullptr ? text : "unknown error";
}

}  // namespace palpate::forcedimension
