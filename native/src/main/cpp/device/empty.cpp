#include "device/empty.h"

namespace palpate {
namespace {

class EmptyDevice : public Device {
 public:
  using Device::Device;

  ReadStatus read(Sample& sample) override {
    sample.timeNanos = ++reads_;
    return ReadStatus::kFresh;
  }

  bool write(const Wrench& wrench) override {
    last_ = wrench;
    return true;
  }

  bool close() override { return true; }

 private:
  int64_t reads_ = 0;
  Wrench last_;
};

}  // namespace

Finding EmptyBackend::probe(Trace&) {
  Finding finding;
  finding.usable = true;
  return finding;
}

std::unique_ptr<Device> EmptyBackend::open(const std::string&, std::shared_ptr<Trace> trace,
                                           std::string&) {
  Specification specification;
  specification.name = "empty";
  specification.watchdog = "nothing: it has no motors";
  return std::make_unique<EmptyDevice>(std::move(trace), specification);
}

}  // namespace palpate
