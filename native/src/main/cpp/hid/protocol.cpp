#include "hid/protocol.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "hid/bytes.h"

namespace palpate::hid {
namespace {

enum StateFlag : uint8_t {
  kCalibrated = 1 << 0,
  kHandPresent = 1 << 1,
  kWatchdogZeroed = 1 << 3,
  kHot = 1 << 4,
};
constexpr uint8_t kWantForce = 1 << 0;
constexpr uint8_t kEnding = 1 << 1;

uint32_t flagsOf(uint8_t state, uint8_t fault) {
  const auto is = [state](StateFlag flag) { return (state & flag) != 0; };
  const bool ready = is(kCalibrated) && is(kHandPresent) && fault == 0;
  uint32_t flags = ready ? uint32_t{kForceReady} : 0;
  flags |= is(kCalibrated) ? 0 : uint32_t{kNeedsCalibration};
  flags |= is(kHot) ? uint32_t{kMotorsHot} : 0;
  flags |= is(kWatchdogZeroed) ? uint32_t{kWatchdogTripped} : 0;
  return flags;
}

/** Unpacks a unit quaternion; the identity if the device sends none. */
void unpackOrientation(const uint8_t* from, double (&dest)[4]) {
  double length2 = 0;
  for (int i = 0; i < 4; i++) {
    dest[i] = int16At(from + 2 * i) / 32767.0;
    length2 += dest[i] * dest[i];
  }
  const double length = std::sqrt(length2);
  for (int i = 0; i < 4; i++) {
    dest[i] = length > 0.5 ? dest[i] / length : (i == 3 ? 1 : 0);
  }
}

int16_t fixed(double value, double unit) {
  return static_cast<int16_t>(std::clamp(std::round(value / unit), -32767.0, 32767.0));
}

}  // namespace

InReport unpackIn(const uint8_t* report) {
  InReport in;
  in.sequence = uint16At(report + 2);
  in.timeMicros = uint32At(report + 4);
  for (int axis = 0; axis < 3; axis++) {
    const auto micrometres = static_cast<int32_t>(uint32At(report + 8 + 4 * axis));
    in.sample.positionMm[axis] = micrometres / 1000.0;
  }
  unpackOrientation(report + 20, in.sample.orientation);
  in.sample.buttons = uint16At(report + 34);
  in.sample.gripperMm = int16At(report + 36) / 100.0;
  in.acknowledged = uint16At(report + 38);
  in.fault = report[40];
  in.sample.motorHeat = report[41] / 255.0;
  in.sample.flags = flagsOf(report[1], in.fault);
  return in;
}

void packOut(const Wrench& wrench, bool ending, uint16_t sequence, uint32_t echoMicros,
             uint8_t (&report)[kOutBytes]) {
  std::memset(report, 0, kOutBytes);
  report[0] = kOutId;
  report[1] = ending ? kEnding : kWantForce;
  putUint16(report + 2, sequence);
  for (int axis = 0; axis < 3; axis++) {
    putInt16(report + 4 + 2 * axis, fixed(wrench.forceNewton[axis], 0.001));
    putInt16(report + 10 + 2 * axis, fixed(wrench.torqueNewtonMetre[axis], 0.0001));
  }
  putInt16(report + 16, fixed(wrench.gripperNewton, 0.001));
  putUint32(report + 20, echoMicros);
}

CapabilitiesStatus unpackCapabilities(const uint8_t* report, size_t length, Capabilities& dest) {
  if (length < kCapabilitiesBytes || report[0] != kCapabilitiesId ||
      std::memcmp(report + 2, "PLPT", 4) != 0) {
    return CapabilitiesStatus::kAnotherReport;
  }
  if (report[1] != kVersion) {
    return report[1] < kVersion ? CapabilitiesStatus::kOlderVersion
                                : CapabilitiesStatus::kNewerVersion;
  }
  dest.maxForceNewton = uint16At(report + 6) / 1000.0;
  dest.continuousForceNewton = uint16At(report + 8) / 1000.0;
  dest.maxStiffnessNewtonPerMm = uint16At(report + 10) / 1000.0;
  dest.maxTorqueNewtonMetre = uint16At(report + 12) / 10000.0;
  dest.workspaceRadiusMm = uint16At(report + 14) / 10.0;
  dest.reportIntervalMicros = uint16At(report + 16);
  dest.watchdogMillis = uint16At(report + 18);
  return CapabilitiesStatus::kOk;
}

}  // namespace palpate::hid
