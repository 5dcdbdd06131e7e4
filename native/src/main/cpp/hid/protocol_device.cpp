#include <algorithm>

#include "device/clock.h"
#include "hid/linked_device.h"
#include "hid/protocol.h"
#include "hid/report_order.h"

namespace palpate::hid {
namespace {

/** A device that uses the protocol of docs/hid-protocol.md. One thread. */
class ProtocolDevice : public LinkedDevice {
 public:
  using LinkedDevice::LinkedDevice;

 private:
  bool take(const uint8_t* bytes, size_t length, Sample& sample) override;
  bool finish(bool fresh, Sample& sample) override;
  size_t pack(const Wrench& wrench, bool ending, uint8_t (&report)[kMostReportBytes]) override;
  bool takeOne(const uint8_t* report, Sample& sample);

  static_assert(Link::kMostReadBytes % kInBytes == 0, "a joined read must not cut a report");

  ReportOrder order_;
  int64_t arrivedNanos_ = 0;
  uint32_t deviceMicros_ = 0;
  uint16_t outSequence_ = 0;
  bool taken_ = false;
};

/** Unpacks one or several whole reports, because some systems join them in one read. */
bool ProtocolDevice::take(const uint8_t* bytes, size_t length, Sample& sample) {
  if (length % kInBytes != 0) {
    counters().wrongLength++;
    return false;
  }
  bool fresh = false;
  for (size_t at = 0; at < length; at += kInBytes) {
    const bool taken = takeOne(bytes + at, sample);
    counters().merged += taken && fresh ? 1 : 0;
    fresh = taken || fresh;
  }
  return fresh;
}

bool ProtocolDevice::takeOne(const uint8_t* report, Sample& sample) {
  if (report[0] != kInId) {
    counters().wrongLength++;
    return false;
  }
  const InReport in = unpackIn(report);
  if (in.fault >= kFatalFault) {
    fail("the device reports fault " + std::to_string(in.fault) + ": switch it off and on");
    return false;
  }
  if (!order_.isNewer(in.sequence, counters())) {
    return false;
  }
  counters().samples++;
  deviceMicros_ = in.timeMicros;
  sample = in.sample;
  sample.timeNanos = order_.unwrapNanos(in.timeMicros);
  return true;
}

/** Counts a sample as late if it comes after more than two report intervals. */
bool ProtocolDevice::finish(bool fresh, Sample&) {
  if (fresh) {
    const int64_t now = steadyNanos();
    const int64_t since = now - arrivedNanos_;
    counters().late += taken_ && since > 2 * specification().reportIntervalNanos ? 1 : 0;
    arrivedNanos_ = now;
    taken_ = true;
  }
  return fresh;
}

size_t ProtocolDevice::pack(const Wrench& wrench, bool ending,
                            uint8_t (&report)[kMostReportBytes]) {
  uint8_t out[kOutBytes];
  packOut(wrench, ending, ++outSequence_, deviceMicros_, out);
  std::copy(std::begin(out), std::end(out), report);
  return kOutBytes;
}

/**
 * Returns the reason to refuse a device because of its feature report 3, and the remedy; empty for
 * kOk.
 */
std::string refusal(CapabilitiesStatus status, uint8_t version) {
  const std::string versions = "it speaks version " + std::to_string(version) +
                               " of the protocol, and this program version " +
                               std::to_string(kVersion) + ": update ";
  switch (status) {
    case CapabilitiesStatus::kOlderVersion:
      return versions + "its firmware";
    case CapabilitiesStatus::kNewerVersion:
      return versions + "this program";
    case CapabilitiesStatus::kAnotherReport:
      return "its feature report 3 is not that of the protocol: update its firmware";
    case CapabilitiesStatus::kOk:
      break;
  }
  return "";
}

Specification specify(const Capabilities& can, const Listed& listed) {
  Specification specification;
  specification.name = listed.product.empty() ? "hand-built device" : listed.product;
  specification.serial = listed.serial;
  specification.watchdog =
      "the device's own watchdog, " + std::to_string(can.watchdogMillis) + " ms";
  specification.maxForceNewton = can.maxForceNewton;
  specification.continuousForceNewton = can.continuousForceNewton;
  specification.maxTorqueNewtonMetre = can.maxTorqueNewtonMetre;
  specification.maxStiffnessNewtonPerMm = can.maxStiffnessNewtonPerMm;
  specification.workspaceRadiusMm = can.workspaceRadiusMm;
  specification.reportIntervalNanos = int64_t{1000} * can.reportIntervalMicros;
  return specification;
}

}  // namespace

std::unique_ptr<Device> openProtocolDevice(Link link, const Listed& listed,
                                           std::shared_ptr<Trace> trace, std::string& why) {
  uint8_t report[kCapabilitiesBytes + 1] = {kCapabilitiesId};
  const int length = traced(*trace, "hid_get_feature_report", link.api().getFeature, link.handle(),
                            report, sizeof report);
  if (length < 0) {
    why = "no capabilities (feature report 3): " + link.api().lastError(link.handle());
    return nullptr;
  }
  Capabilities can;
  why = refusal(unpackCapabilities(report, static_cast<size_t>(length), can), report[1]);
  if (!why.empty()) {
    return nullptr;
  }
  if (can.watchdogMillis <= 0) {
    why = "it has no watchdog: force would stay on after a crash: update its firmware";
    return nullptr;
  }
  if (can.workspaceRadiusMm <= 0 || (can.maxForceNewton > 0 && can.maxStiffnessNewtonPerMm <= 0)) {
    why = "its capabilities name no workspace or no stiffness: set them in its firmware";
    return nullptr;
  }
  return std::make_unique<ProtocolDevice>(std::move(link), std::move(trace), specify(can, listed));
}

}  // namespace palpate::hid
