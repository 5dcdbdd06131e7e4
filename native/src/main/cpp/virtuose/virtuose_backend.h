#ifndef PALPATE_VIRTUOSE_VIRTUOSE_BACKEND_H
#define PALPATE_VIRTUOSE_VIRTUOSE_BACKEND_H

#include "device/device.h"

namespace palpate::virtuose {

/** The back end for Haption's INCA 6D and Virtuose 6D, by the Virtuose API. */
class VirtuoseBackend : public Backend {
 public:
  const char* name() const override { return "virtuose"; }
  Finding probe(Trace& trace) override;
  std::unique_ptr<Device> open(const std::string& id, std::shared_ptr<Trace> trace,
                               std::string& why) override;
};

}  // namespace palpate::virtuose

#endif
