#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "device/clock.h"
#include "hid/bytes.h"
#include "hid/hid_backend.h"
#include "hid/protocol.h"

namespace palpate::hid {
namespace {

constexpr int64_t kListenMillis = 100;
constexpr int64_t kExchangeMillis = 100;
/** Bounds of the silence after the last force, which is twice the watchdog's time. */
constexpr int64_t kLeastSilenceMillis = 60;
constexpr int64_t kMostSilenceMillis = 1000;

/** Returns the real time, us. A test's own clock does not advance while a device answers. */
int64_t microsNow() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

std::string hex(const uint8_t* bytes, size_t length) {
  std::string text;
  char two[3];
  for (size_t i = 0; i < length; i++) {
    std::snprintf(two, sizeof two, "%02x", static_cast<unsigned>(bytes[i]));
    text += two;
  }
  return text;
}

/**
 * Returns Linux's file with the report descriptor of a node, for versions of hidapi without that
 * function.
 */
std::string descriptorFile(const std::string& path) {
  const std::string node = path.substr(path.rfind('/') + 1);
  std::ifstream file("/sys/class/hidraw/" + node + "/device/report_descriptor", std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  return hex(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size());
}

/** A capture in progress. One thread. */
class Capture {
 public:
  Capture(const Link& link, Trace& trace) : link_(link), trace_(trace), start_(microsNow()) {}

  void describe(const Listed& listed);
  int64_t watchdogMillis();
  void run(int64_t millis, bool sends);
  void goodbye() { send(true); }
  std::string text() const { return text_; }

 private:
  void line(const std::string& key, const std::string& value) { text_ += key + " " + value + "\n"; }
  std::string at() const { return std::to_string(microsNow() - start_) + " "; }
  void receive();
  void send(bool ending);

  const Link& link_;
  Trace& trace_;
  const int64_t start_;
  std::string text_;
  uint32_t deviceMicros_ = 0;
  uint16_t sequence_ = 0;
};

void Capture::describe(const Listed& listed) {
  const HidApi& api = link_.api();
  uint8_t bytes[4096];
  int length = -1;
  if (api.getReportDescriptor != nullptr) {
    length = traced(trace_, "hid_get_report_descriptor", api.getReportDescriptor, link_.handle(),
                    bytes, sizeof bytes);
  }
  line("name", listed.product);
  line("descriptor",
       length > 0 ? hex(bytes, static_cast<size_t>(length)) : descriptorFile(listed.path));
}

/** Returns the watchdog's time in feature report 3, ms; 0 if there is no such report. */
int64_t Capture::watchdogMillis() {
  uint8_t report[kCapabilitiesBytes + 1] = {kCapabilitiesId};
  const int length = traced(trace_, "hid_get_feature_report", link_.api().getFeature,
                            link_.handle(), report, sizeof report);
  const size_t got = length > 0 ? static_cast<size_t>(length) : 0;
  line("feature", hex(report, got));
  Capabilities can;
  return unpackCapabilities(report, got, can) == CapabilitiesStatus::kOk ? can.watchdogMillis : 0;
}

void Capture::receive() {
  uint8_t bytes[Link::kMostReadBytes];
  const int length = traced(trace_, "hid_read_timeout", link_.api().readTimeout, link_.handle(),
                            bytes, sizeof bytes, 1);
  const size_t got = length > 0 ? static_cast<size_t>(length) : 0;
  if (got > 0) {
    line("in", at() + hex(bytes, got));
  }
  if (got >= kInBytes) {
    deviceMicros_ = uint32At(bytes + got - kInBytes + 4);  // of the last of joined reports
  }
}

void Capture::send(bool ending) {
  uint8_t report[kOutBytes];
  packOut(Wrench(), ending, ++sequence_, deviceMicros_, report);
  if (!ending) {
    report[1] = 0;  // no force is requested
  }
  line("out", at() + hex(report, sizeof report));
  traced(trace_, "hid_write", link_.api().write, link_.handle(), report, sizeof report);
}

void Capture::run(int64_t millis, bool sends) {
  const int64_t end = microsNow() + 1000 * millis;
  int64_t next = microsNow();
  while (microsNow() < end) {
    receive();
    if (sends && microsNow() >= next) {
      send(false);
      next += 1000;
    }
  }
}

}  // namespace

std::string captureDevice(const Link& link, const Listed& listed, Trace& trace) {
  Capture capture(link, trace);
  capture.describe(listed);
  const int64_t watchdog = capture.watchdogMillis();
  capture.run(kListenMillis, false);
  capture.run(kExchangeMillis, true);
  capture.run(std::min(std::max(2 * watchdog, kLeastSilenceMillis), kMostSilenceMillis), false);
  capture.goodbye();
  return capture.text();
}

}  // namespace palpate::hid
