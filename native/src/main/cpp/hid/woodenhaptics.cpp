#include <algorithm>
#include <cmath>

#include "device/clock.h"
#include "hid/bytes.h"
#include "hid/hid_backend.h"
#include "hid/wooden_kinematics.h"

namespace palpate::hid {
namespace {

/**
 * WoodenHaptics over USB: encoder counts in (8 bytes), motor currents in mA out (a report id of 0
 * and 8 bytes). Its firmware has no watchdog. One thread.
 */
class WoodenHaptics : public Device {
 public:
  WoodenHaptics(Link link, std::shared_ptr<Trace> trace, Specification specification)
      : Device(std::move(trace), std::move(specification)), link_(std::move(link)) {}

  ReadStatus read(Sample& sample) override;
  bool write(const Wrench& wrench) override;
  bool close() override;

 private:
  static constexpr size_t kInBytes = 8;
  static constexpr size_t kOutBytes = 9;
  static constexpr int kMostReadsAFrame = 64;
  /** What its amplifiers deliver at most. */
  static constexpr double kMostMilliampere = 3000;

  void take(const uint8_t* report);
  void fill(Sample& sample);
  void pack(const double (&forceNewton)[3], uint8_t (&report)[kOutBytes]);

  Link link_;
  WoodenArm arm_;
  bool started_ = false;
  int16_t last_[3] = {0, 0, 0};
  double counts_[3] = {0, 0, 0};
  double anglesRad_[3] = {0, 0, 0};
};

/** The counters are 16 bits wide and wrap; what matters is how far they went since. */
void WoodenHaptics::take(const uint8_t* report) {
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

void WoodenHaptics::fill(Sample& sample) {
  double tipMetre[3];
  woodenAngles(arm_, counts_, anglesRad_);
  woodenTip(arm_, anglesRad_, tipMetre);
  sample.positionMm[0] = tipMetre[1] * 1000;
  sample.positionMm[1] = tipMetre[2] * 1000;
  sample.positionMm[2] = tipMetre[0] * 1000;
  sample.timeNanos = steadyNanos();
  sample.flags = kForceReady;
}

ReadStatus WoodenHaptics::read(Sample& sample) {
  uint8_t report[64];
  bool fresh = false;
  for (int i = 0; i < kMostReadsAFrame; i++) {
    const int length = link_.read(report, sizeof report, trace(), counters());
    if (length <= 0) {
      break;
    }
    if (length != static_cast<int>(kInBytes)) {
      counters().wrongLength++;
    } else {
      counters().merged += fresh ? 1 : 0;
      take(report);
      fresh = true;
    }
  }
  if (link_.isGone()) {
    return ReadStatus::kDisconnected;
  }
  if (fresh) {
    fill(sample);
  }
  return fresh ? ReadStatus::kFresh : ReadStatus::kRepeated;
}

void WoodenHaptics::pack(const double (&forceNewton)[3], uint8_t (&report)[kOutBytes]) {
  double ampere[3];
  const double theirs[3] = {forceNewton[2], forceNewton[0], forceNewton[1]};
  woodenCurrents(arm_, anglesRad_, theirs, ampere);
  std::fill(std::begin(report), std::end(report), uint8_t{0});
  for (int body = 0; body < 3; body++) {
    const double milli = std::round(ampere[body] * 1000);
    putInt16(report + 1 + 2 * body,
             static_cast<int16_t>(std::clamp(milli, -kMostMilliampere, kMostMilliampere)));
  }
}

bool WoodenHaptics::write(const Wrench& wrench) {
  uint8_t report[kOutBytes];
  pack(wrench.forceNewton, report);
  return link_.write(report, sizeof report, trace(), counters());
}

bool WoodenHaptics::close() {
  const double none[3] = {0, 0, 0};
  uint8_t report[kOutBytes];
  pack(none, report);
  return link_.closeWith(report, sizeof report, trace());
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
