#include <algorithm>

#include "device/clock.h"
#include "hid/bytes.h"
#include "hid/linked_device.h"

namespace palpate::hid {
namespace {

/**
 * A 3Dconnexion SpaceMouse. The displacement of its cap is the velocity of the device position. It
 * has no force. Its axes point to the right, towards the person and down. One thread.
 */
class SpaceMouse : public LinkedDevice {
 public:
  using LinkedDevice::LinkedDevice;

  static constexpr double kReachMm = 100;

 private:
  static constexpr double kFullDeflection = 350;
  static constexpr double kFullSpeedMmPerSecond = 80;
  static constexpr double kLongestStepSeconds = 0.05;

  bool take(const uint8_t* bytes, size_t length, Sample& sample) override;
  bool finish(bool fresh, Sample& sample) override;
  size_t pack(const Wrench&, bool, uint8_t (&)[kMostReportBytes]) override { return 0; }
  void move(int64_t nowNanos);

  double deflection_[3] = {0, 0, 0};
  double positionMm_[3] = {0, 0, 0};
  uint32_t buttons_ = 0;
  int64_t movedNanos_ = 0;
};

/** Unpacks a report, which holds only a part of a sample. */
bool SpaceMouse::take(const uint8_t* report, size_t length, Sample&) {
  if (report[0] == 1 && (length == 7 || length == 13)) {
    deflection_[0] = int16At(report + 1);
    deflection_[1] = -int16At(report + 5);
    deflection_[2] = int16At(report + 3);
  } else if (report[0] == 3 && length >= 2) {
    buttons_ = report[1] | (length > 2 ? static_cast<uint32_t>(report[2]) << 8 : 0);
  } else if (report[0] == 1 || report[0] == 3) {
    counters().wrongLength++;
    return false;
  }
  counters().samples++;
  return false;
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

/**
 * Makes a sample of every read, because the position moves on without reports while the cap is
 * pushed.
 */
bool SpaceMouse::finish(bool, Sample& sample) {
  const int64_t now = steadyNanos();
  move(now);
  sample.timeNanos = now;
  sample.buttons = buttons_;
  std::copy(std::begin(positionMm_), std::end(positionMm_), sample.positionMm);
  return true;
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
