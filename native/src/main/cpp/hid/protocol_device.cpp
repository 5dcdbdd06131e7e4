#include <algorithm>

#include "device/clock.h"
#include "hid/hid_backend.h"
#include "hid/protocol.h"
#include "hid/report_order.h"

namespace palpate::hid {
namespace {

/** A device that speaks our protocol. One thread. */
class ProtocolDevice : public Device {
 public:
  ProtocolDevice(Link link, std::shared_ptr<Trace> trace, Specification specification)
      : Device(std::move(trace), std::move(specification)), link_(std::move(link)) {}

  ReadStatus read(Sample& sample) override;
  bool write(const Wrench& wrench) override;
  bool close() override;

 private:
  /** So many reports at once are drained; a device that sends faster is faulty. */
  static constexpr int kMostReadsAFrame = 64;
  static constexpr size_t kMostMerged = 4;
  /** So many writes in a row may fail before the device counts as gone. */
  static constexpr int kMostFailedWrites = 3;
  static constexpr int kGoodbyes = 3;

  bool takeAll(const uint8_t* bytes, size_t length, Sample& sample);
  bool take(const uint8_t* report, Sample& sample);
  void countLateness();
  bool send(const Wrench& wrench, bool ending);
  ReadStatus gone(const std::string& why);

  Link link_;
  ReportOrder order_;
  int64_t arrivedNanos_ = 0;
  uint32_t deviceMicros_ = 0;
  uint16_t outSequence_ = 0;
  int failedWrites_ = 0;
  bool gone_ = false;
  bool taken_ = false;
};

ReadStatus ProtocolDevice::gone(const std::string& why) {
  gone_ = true;
  trace().end(why);
  return ReadStatus::kDisconnected;
}

ReadStatus ProtocolDevice::read(Sample& sample) {
  if (gone_) {
    return ReadStatus::kDisconnected;
  }
  uint8_t bytes[kMostMerged * kInBytes];
  bool fresh = false;
  for (int i = 0; i < kMostReadsAFrame; i++) {
    const int length = traced(trace(), "hid_read_timeout", link_.api().readTimeout, link_.handle(),
                              bytes, sizeof bytes, 0);
    if (length < 0) {
      return gone("the device is gone: hid_read_timeout: " + link_.api().lastError(link_.handle()));
    }
    if (length == 0) {
      break;
    }
    fresh = takeAll(bytes, static_cast<size_t>(length), sample) || fresh;
    if (gone_) {
      return ReadStatus::kDisconnected;
    }
  }
  if (fresh) {
    countLateness();
  }
  return fresh ? ReadStatus::kFresh : ReadStatus::kRepeated;
}

/** One read may bring several whole reports where the system below joins them. */
bool ProtocolDevice::takeAll(const uint8_t* bytes, size_t length, Sample& sample) {
  if (length % kInBytes != 0) {
    counters().wrongLength++;
    return false;
  }
  bool fresh = false;
  for (size_t at = 0; at < length && !gone_; at += kInBytes) {
    const bool taken = take(bytes + at, sample);
    counters().merged += taken && fresh ? 1 : 0;
    fresh = taken || fresh;
  }
  return fresh;
}

bool ProtocolDevice::take(const uint8_t* report, Sample& sample) {
  if (report[0] != kInId) {
    counters().wrongLength++;
    return false;
  }
  const InReport in = unpackIn(report);
  if (in.fault >= kFatalFault) {
    gone("the device reports fault " + std::to_string(in.fault) + ": switch it off and on");
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

void ProtocolDevice::countLateness() {
  const int64_t now = steadyNanos();
  const int64_t since = now - arrivedNanos_;
  counters().late += taken_ && since > 2 * specification().reportIntervalNanos ? 1 : 0;
  arrivedNanos_ = now;
  taken_ = true;
}

bool ProtocolDevice::send(const Wrench& wrench, bool ending) {
  uint8_t report[kOutBytes];
  packOut(wrench, ending, ++outSequence_, deviceMicros_, report);
  return traced(trace(), "hid_write", link_.api().write, link_.handle(),
                static_cast<const unsigned char*>(report),
                sizeof report) == static_cast<int>(sizeof report);
}

bool ProtocolDevice::write(const Wrench& wrench) {
  if (gone_) {
    return false;
  }
  if (send(wrench, false)) {
    failedWrites_ = 0;
    return true;
  }
  counters().errors++;
  if (++failedWrites_ >= kMostFailedWrites) {
    gone("the device takes no force: hid_write: " + link_.api().lastError(link_.handle()));
  }
  return !gone_;
}

bool ProtocolDevice::close() {
  bool sent = false;
  for (int i = 0; i < kGoodbyes && !sent; i++) {
    sent = send(Wrench(), true);
  }
  link_.close(&trace());
  return sent;
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
  Capabilities can;
  if (length < 0) {
    why = "no capabilities (feature report 3): " + link.api().lastError(link.handle());
    return nullptr;
  }
  if (!unpackCapabilities(report, static_cast<size_t>(length), can)) {
    why = "its capabilities (feature report 3) are not of protocol version 1: update its firmware";
    return nullptr;
  }
  if (can.watchdogMillis <= 0) {
    why = "it has no watchdog: force would stay on after a crash: update its firmware";
    return nullptr;
  }
  return std::make_unique<ProtocolDevice>(std::move(link), std::move(trace), specify(can, listed));
}

}  // namespace palpate::hid
