#ifndef PALPATE_FORCEDIMENSION_FORCEDIMENSION_BACKEND_H
#define PALPATE_FORCEDIMENSION_FORCEDIMENSION_BACKEND_H

#include "device/device.h"

namespace palpate::forcedimension {

/**
 * The back end for Force Dimension's omega, delta, sigma and lambda, and Novint's Falcon, by DHD.
 */
class ForceDimensionBackend : public Backend {
 public:
  const char* name() const override { return "forcedimension"; }
  Finding probe(Trace& trace) override;
  std::unique_ptr<Device> open(const std::string& id, std::shared_ptr<Trace> trace,
                               std::string& why) override;
};

}  // namespace palpate::forcedimension

#endif
