#ifndef PALPATE_FORCEDIMENSION_FORCEDIMENSION_BACKEND_H
#define PALPATE_FORCEDIMENSION_FORCEDIMENSION_BACKEND_H

#include "device/device.h"

namespace palpate::forcedimension {

/** Force Dimension's devices through DHD: omega, delta, sigma, lambda, and Novint's Falcon. */
class ForceDimensionBackend : public Backend {
 public:
  const char* name() const override { return "forcedimension"; }
  Finding probe(Trace& trace) override;
  std::unique_ptr<Device> open(const std::string& id, std::shared_ptr<Trace> trace,
                               std::string& why) override;
};

}  // namespace palpate::forcedimension

#endif
