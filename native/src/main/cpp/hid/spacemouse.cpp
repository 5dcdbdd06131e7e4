#include <algorithm>

#include "device/clock.h"
#include "hid/bytes.h"
#include "hid/hid_backend.h"

namespace palpate::hid {
namespace {

/**
 * A 3Dconnexion SpaceMouse: how far its cap is pushed is how fast the point moves. It has no force.
 * Its axes run to the right, towards the person and down; ours to the right, up and towards. One
 * thread.
 */
class SpaceMouse : public Device {
 public:
  SpaceMouse(Link link, std::shared_ptr<Trace> trace, Specification specification)
      : Device(std::move(trace), std::move(specification)), link_(std::move(link)) {}

  ReadStatus read(Sample& sample) override;
  bool write(const Wrench&) override { return !link_.isGone(); }
  bool close() override {
    link_.close(&trace());
    return true;
  }

  static constexpr double kReachMm = 100;

 private:
  static constexpr double kFullDeflection = 350;
  static constexpr double kFullSpeedMmPerSecond = 80;
  static constexpr double kLongestStepSeconds = 0.05;
  static constexpr int kMostReadsAFrame = 32;

  void take(const uint8_t* report, size_t length);
  void move(int64_t nowNanos);

  Link link_;
  double deflection_[3] = {0, 0, 0};
  double positionMm_[3] = {0, 0, 0};
  uint32_t buttons_ = 0;
  int64_t movedNanos_ = 0;
};

void SpaceMouse::take(const uint8_t* report, size_t length) {
  if (report[0] == 1 && (length == 7 || length == 13)) {
    deflection_[0] = int16At(report + 1);
    deflection_[1] = -int16At(report + 5);
    deflection_[2] = int16At(report + 3);
  } else if (report[0] == 3 && length >= 2) {
    buttons_ = report[1] | (length > 2 ? static_cast<uint32_t>(report[2]) << 8 : 0);
  } else if (report[0] == 1 || report[0] == 3) {
    counters().wrongLength++;
    return;
  }
  counters().samples++;
}

void SpaceMouse::move(int64_t nowNanos) {
  const double elapsed = static_cast<double>(nowNanos - movedNanos_) / kNanosPerSecond;
  const double seconds = movedNanos_ == 0 ? 0 : std::clamp(elapsed, 0.0, kLongestStepSeconds);
  movedNanos_ = nowNanos;
  for (int axis = 0; axis < 3; axis++) {
    const double share = std::clamp(deflection_[axis] / kFullDeflection, -1.0, 1.0);
    const double moved = positionMm_[axis] + share * kFullSpeedMmPerSecond * seconds;
    positionMm_[axis] = std::clamp(moved, -kReachMm, kReachMm);
  }
}

ReadStatus SpaceMouse::read(Sample& sample) {
  uint8_t report[64];
  for (int i = 0; i < kMostReadsAFrame; i++) {
    const int length = link_.read(report, sizeof report, trace(), counters());
    if (length <= 0) {
      break;
    }
    take(report, static_cast<size_t>(length));
  }
  if (link_.isGone()) {
    return ReadStatus::kDisconnected;
  }
  const int64_t now = steadyNanos();
  move(now);
  sample.timeNanos = now;
  sample.buttons = buttons_;
  std::copy(std::begin(positionMm_), std::end(positionMm_), sample.positionMm);
  return ReadStatus::kFresh;
}

}  // namespace

std::unique_ptr<Device> openSpaceMouse(Link link, const Listed& listed,
                                       std::shared_ptr<Trace> trace, std::string&) {
  Specification specification;
  specification.name = listed.product.empty() ? "SpaceMouse" : listed.product;
  specification.serial = listed.serial;
  specification.watchdog = "nothing: it has no motors";
  specification.workspaceRadiusMm = SpaceMouse::kReachMm;
  return std::make_unique<SpaceMouse>(std::move(link), std::move(trace), specification);
}

}  // namespace palpate::hid
