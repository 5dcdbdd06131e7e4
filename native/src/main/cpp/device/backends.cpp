#include "device/device.h"
#include "device/empty.h"
#include "forcedimension/forcedimension_backend.h"
#include "hid/hid_backend.h"
#include "openhaptics/openhaptics_backend.h"
#include "virtuose/virtuose_backend.h"

namespace palpate {

const std::vector<Backend*>& backends() {
  static const auto* all = new std::vector<Backend*>{
      new hid::HidBackend(),
      new openhaptics::OpenHapticsBackend(),
      new forcedimension::ForceDimensionBackend(),
      new virtuose::VirtuoseBackend(),
  };  // outlives threads that hang in a vendor
  return *all;
}

Backend* backendNamed(const std::string& name) {
  static auto* empty = new EmptyBackend();
  for (Backend* backend : backends()) {
    if (name == backend->name()) {
      return backend;
    }
  }
  return name == empty->name() ? empty : nullptr;
}

}  // namespace palpate
