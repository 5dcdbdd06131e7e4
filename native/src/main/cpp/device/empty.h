#ifndef PALPATE_DEVICE_EMPTY_H
#define PALPATE_DEVICE_EMPTY_H

#include "device/device.h"

namespace palpate {

/**
 * A device without hardware: every read is a new sample at the origin, and every force is accepted.
 * It measures the cost of calls from Java alone. It is not listed; its name is "empty".
 */
class EmptyBackend : public Backend {
 public:
  const char* name() const override { return "empty"; }
  Finding probe(Trace& trace) override;
  std::unique_ptr<Device> open(const std::string& id, std::shared_ptr<Trace> trace,
                               std::string& why) override;
};

}  // namespace palpate

#endif
