#ifndef PALPATE_OPENHAPTICS_OPENHAPTICS_BACKEND_H
#define PALPATE_OPENHAPTICS_OPENHAPTICS_BACKEND_H

#include "device/device.h"

namespace palpate::openhaptics {

/** The back end for 3D Systems' (SensAble's) Omni, Touch and Premium, by HDAPI. */
class OpenHapticsBackend : public Backend {
 public:
  const char* name() const override { return "openhaptics"; }
  Finding probe(Trace& trace) override;
  std::unique_ptr<Device> open(const std::string& id, std::shared_ptr<Trace> trace,
                               std::string& why) override;
};

}  // namespace palpate::openhaptics

#endif
