#include <algorithm>
#include <cmath>

#include "device/clock.h"
#include "hid/bytes.h"
#include "hid/linked_device.h"
#include "hid/wooden_kinematics.h"

namespace palpate::hid {
namespace {

/**
 * WoodenHaptics over USB. It sends encoder counts (8 bytes) and receives motor currents in mA (a
 * report id of 0 and 8 bytes). Its firmware has no watchdog. One thread.
 */
class WoodenHaptics : public LinkedDevice {
 public:
  using LinkedDevice::LinkedDevice;

 private:
  static constexpr size_t kInBytes = 8;
  static constexpr size_t kOutBytes = 9;
  /** The largest current of its amplifiers. */
  static constexpr double kMostMilliampere = 3000;

  bool take(const uint8_t* bytes, size_t length, Sample& sample) override;
  bool finish(bool fresh, Sample& sample) override;
  size_t pack(const Wrench& wrench, bool ending, uint8_t (&report)[kMostReportBytes]) override;
  void count(const uint8_t* report);

  WoodenArm arm_;
  bool started_ = false;
  int16_t last_[3] = {0, 0, 0};
  double counts_[3] = {0, 0, 0};
  double anglesRad_[3] = {0, 0, 0};
};

/**
 * Adds the differences of the encoder counts since the last report, because the 16-bit counters
 * wrap.
 */
void WoodenHaptics::count(const uint8_t* report) {
  for (int body = 0; body < 3; body++) {
    const int16_t count = int16At(report + 2 * body);
    const auto step = static_cast<int16_t>(
        static_cast<uint16_t>(static_cast<uint16_t>(count) - static_cast<uint16_t>(last_[body])));
    counts_[body] += started_ ? step : count;
    last_[body] = count;
  }
  started_ = true;
  counters().samples++;
}

bool WoodenHaptics::take(const uint8_t* bytes, size_t length, Sample&) {
  if (length != kInBytes) {
    counters().wrongLength++;
    return false;
  }
  count(bytes);
  return true;
}

bool WoodenHaptics::finish(bool fresh, Sample& sample) {
  if (!fresh) {
    return false;
  }
  double tipMetre[3];
  woodenAngles(arm_, counts_, anglesRad_);
  woodenTip(arm_, anglesRad_, tipMetre);
  sample.positionMm[0] = tipMetre[1] * 1000;
  sample.positionMm[1] = tipMetre[2] * 1000;
  sample.positionMm[2] = tipMetre[0] * 1000;
  sample.timeNanos = steadyNanos();
  sample.flags = kForceReady;
  return true;
}

size_t WoodenHaptics::pack(const Wrench& wrench, bool, uint8_t (&report)[kMostReportBytes]) {
  const double* force = wrench.forceNewton;
  const double theirs[3] = {force[2], force[0], force[1]};
  double ampere[3];
  woodenCurrents(arm_, anglesRad_, theirs, ampere);
  std::fill_n(report, kOutBytes, uint8_t{0});
  for (int body = 0; body < 3; body++) {
    const double milli = std::round(ampere[body] * 1000);
    putInt16(report + 1 + 2 * body,
             static_cast<int16_t>(std::clamp(milli, -kMostMilliampere, kMostMilliampere)));
  }
  return kOutBytes;
}

}  // namespace

std::unique_ptr<Device> openWoodenHaptics(Link link, const Listed& listed,
                                          std::shared_ptr<Trace> trace, std::string&) {
  Specification specification;
  specification.name = "WoodenHaptics";
  specification.serial = listed.serial;
  specification.watchdog = "nobody: it has no watchdog, switch its amplifiers off";
  specification.maxForceNewton = 12;
  specification.continuousForceNewton = 6;
  specification.maxStiffnessNewtonPerMm = 5;
  specification.workspaceRadiusMm = 100;
  specification.reportIntervalNanos = kNanosPerMilli;
  return std::make_unique<WoodenHaptics>(std::move(link), std::move(trace), specification);
}

}  // namespace palpate::hid
