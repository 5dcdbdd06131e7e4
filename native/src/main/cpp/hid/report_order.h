#ifndef PALPATE_HID_REPORT_ORDER_H
#define PALPATE_HID_REPORT_ORDER_H

#include "device/frame.h"

namespace palpate::hid {

/**
 * Distinguishes new reports from old ones by their 16-bit sequence number, and counts faults. One
 * thread.
 */
class ReportOrder {
 public:
  /** After this many old reports in succession, the device counts as restarted. */
  static constexpr int kRestartAfter = 32;

  /** Whether a report with this sequence number is newer than all earlier ones. */
  bool isNewer(uint16_t sequence, Counters& counters) {
    const auto step = static_cast<int16_t>(static_cast<uint16_t>(sequence - last_));
    if (started_ && step <= 0 && ++old_ < kRestartAfter) {
      counters.duplicated += step == 0 ? 1 : 0;
      counters.outOfOrder += step < 0 ? 1 : 0;
      return false;
    }
    counters.lost += started_ && step > 1 ? step - 1 : 0;
    started_ = true;
    old_ = 0;
    last_ = sequence;
    return true;
  }

  /** Converts the device's 32-bit microseconds to nanoseconds that do not wrap. */
  int64_t unwrapNanos(uint32_t micros) {
    micros_ += timed_ ? static_cast<uint32_t>(micros - lastMicros_) : micros;
    timed_ = true;
    lastMicros_ = micros;
    return micros_ * 1000;
  }

 private:
  bool started_ = false;
  bool timed_ = false;
  int old_ = 0;
  uint16_t last_ = 0;
  uint32_t lastMicros_ = 0;
  int64_t micros_ = 0;
};

}  // namespace palpate::hid

#endif
