#include "hid/linked_device.h"

namespace palpate::hid {

ReadStatus LinkedDevice::read(Sample& sample) {
  uint8_t bytes[Link::kMostReadBytes];
  bool fresh = false;
  for (int i = 0; i < kMostReadsAFrame && !faulty_; i++) {
    const int length = link_.read(bytes, sizeof bytes, trace(), counters());
    if (length <= 0) {
      break;
    }
    const bool taken = take(bytes, static_cast<size_t>(length), sample);
    counters().merged += taken && fresh ? 1 : 0;
    fresh = taken || fresh;
  }
  if (faulty_ || link_.isGone()) {
    return ReadStatus::kDisconnected;
  }
  return finish(fresh, sample) ? ReadStatus::kFresh : ReadStatus::kRepeated;
}

bool LinkedDevice::write(const Wrench& wrench) {
  uint8_t report[kMostReportBytes];
  const size_t length = pack(wrench, false, report);
  if (length == 0) {
    return !link_.isGone();
  }
  return !faulty_ && link_.write(report, length, trace(), counters());
}

bool LinkedDevice::close() {
  uint8_t report[kMostReportBytes];
  const size_t length = pack(Wrench(), true, report);
  if (length == 0) {
    link_.close(&trace());
    return true;
  }
  return link_.closeWith(report, length, trace());
}

void LinkedDevice::fail(const std::string& why) {
  faulty_ = true;
  trace().end(why);
}

}  // namespace palpate::hid
