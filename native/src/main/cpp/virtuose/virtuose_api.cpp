#include "virtuose/virtuose_api.h"

#include <vector>

#include "device/library.h"

namespace palpate::virtuose {
namespace {

std::vector<std::string> names() {
#if defined(_WIN32)
  return {"virtuoseAPI.dll"};
#elif defined(__APPLE__)
  return {"libVirtuoseAPI.dylib"};
#else
  return {"libVirtuoseAPI.so", "libvirtuose.so"};
#endif
}

}  // namespace

VirtuoseApi& VirtuoseApi::instance() {
  static auto* api = new VirtuoseApi();  // outlives a thread that hangs in it
  return *api;
}

VirtuoseApi::VirtuoseApi() {
  const Wanted wanted{names(), nullptr, "Haption's Virtuose API", "install version 4 or newer",
                      "install Virtuose API 4 or newer"};
  findFunctions(wanted, *this, [this](Library& found) {
    if (!found.need("virtOpen", open)) {
      // Version 3 defines its functions in the header, over one exported function with a number.
      whyNot = library + " is older than version 4: install Virtuose API 4 or newer";
      return;
    }
    found.need("virtClose", close);
    found.need("virtGetErrorCode", getErrorCode);
    found.need("virtGetErrorMessage", getErrorMessage);
    found.need("virtAPIVersion", apiVersion);
    found.need("virtSetIndexingMode", setIndexingMode);
    found.need("virtSetForceFactor", setForceFactor);
    found.need("virtSetSpeedFactor", setSpeedFactor);
    found.need("virtSetTimeStep", setTimeStep);
    found.need("virtSetTimeoutValue", setTimeoutValue);
    found.need("virtSetBaseFrame", setBaseFrame);
    found.need("virtSetObservationFrame", setObservationFrame);
    found.need("virtSetCommandType", setCommandType);
    found.need("virtSaturateTorque", saturateTorque);
    found.need("virtSetPowerOn", setPowerOn);
    found.need("virtGetPosition", getPosition);
    found.need("virtSetForce", setForce);
    found.need("virtGetButton", getButton);
    found.need("virtGetDeadMan", getDeadMan);
    found.need("virtGetEmergencyStop", getEmergencyStop);
    found.need("virtGetPowerOn", getPowerOn);
    found.need("virtGetAlarm", getAlarm);
  });
}

std::string VirtuoseApi::lastError(Context context) const {
  const char* text = getErrorMessage(getErrorCode(context));
  return text != nullptr ? text : "unknown error";
}

}  // namespace palpate::virtuose
