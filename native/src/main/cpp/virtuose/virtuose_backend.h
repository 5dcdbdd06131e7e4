#ifndef PALPATE_VIRTUOSE_VIRTUOSE_BACKEND_H
#define PALPATE_VIRTUOSE_VIRTUOSE_BACKEND_H

#include "device/device.h"

namespace palpate::virtuose {

/** Haption's devices through the Virtuose API: INCA 6D, Virtuose 6D. */
class VirtuoseBackend : public Backend {
 public:
  const char* name() const override { return "virtuose"; }
  Finding probe(Trace& trace) override;
  std::unique_ptr<Device> open(const std::string& id, std::shared_ptr<Trace> trace,
                               std::string& why) override;
};

}  // namespace palpate::virtuose

#endif
