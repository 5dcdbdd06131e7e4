#ifndef PALPATE_HID_HID_BACKEND_H
#define PALPATE_HID_HID_BACKEND_H

#include "device/device.h"
#include "hid/hidapi.h"

namespace palpate::hid {

/**
 * The back end for HID devices: hand-built ones with the protocol of docs/hid-protocol.md,
 * WoodenHaptics, and the 3Dconnexion SpaceMouse, which has no force.
 */
class HidBackend : public Backend {
 public:
  const char* name() const override { return "hid"; }
  Finding probe(Trace& trace) override;
  std::unique_ptr<Device> open(const std::string& id, std::shared_ptr<Trace> trace,
                               std::string& why) override;
  std::string capture(const std::string& id, Trace& trace, std::string& why) override;

 private:
  struct Opened;

  /**
   * Opens a handle. The caller holds the lock of HidApi. If there is no handle, `why` has the
   * reason.
   */
  static Opened openHandle(const std::string& id, Trace& trace, std::string& why);
};

/**
 * Owns an open device of hidapi and closes it in its destructor. It can be moved but not copied.
 */
class Link {
 public:
  static constexpr size_t kMostReadBytes = 192;  // some systems join reports

  Link(HidApi& api, Handle* handle) : api_(&api), handle_(handle) {}
  Link(Link&& other) noexcept : api_(other.api_), handle_(other.handle_) {
    other.handle_ = nullptr;
  }
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  ~Link() { close(nullptr); }

  HidApi& api() const { return *api_; }
  Handle* handle() const { return handle_; }

  /**
   * Reads once without waiting. Returns the number of bytes: 0 if there is no report or after a
   * single failure. After several failures in succession it returns -1: the device is gone, and
   * `trace` has the reason.
   */
  int read(uint8_t* bytes, size_t length, Trace& trace, Counters& counters);

  /** Writes one report. Several failures in succession set `isGone`, as in read. */
  bool write(const uint8_t* bytes, size_t length, Trace& trace, Counters& counters);

  /** Whether the device is gone. */
  bool isGone() const { return gone_; }

  /** Sends the last report up to three times until it is accepted, then closes the device. */
  bool closeWith(const uint8_t* bytes, size_t length, Trace& trace);

  void close(Trace* trace);

 private:
  static constexpr int kMostFailures = 5;
  static constexpr int kGoodbyes = 3;

  void failed(const char* call, int& inARow, Trace& trace, Counters& counters);
  bool send(const uint8_t* bytes, size_t length, Trace& trace);

  HidApi* api_;
  Handle* handle_;
  int failedReads_ = 0;
  int failedWrites_ = 0;
  bool gone_ = false;
};

/** Returns one line for a system's error at opening a device's node: the reason and the remedy. */
std::string refusal(const Listed& listed, int error);

/**
 * Opens a device of one kind over a link. Returns nullptr and fills `why` if it is none of that
 * kind.
 */
std::unique_ptr<Device> openProtocolDevice(Link link, const Listed& listed,
                                           std::shared_ptr<Trace> trace, std::string& why);
std::unique_ptr<Device> openWoodenHaptics(Link link, const Listed& listed,
                                          std::shared_ptr<Trace> trace, std::string& why);
std::unique_ptr<Device> openSpaceMouse(Link link, const Listed& listed,
                                       std::shared_ptr<Trace> trace, std::string& why);

/**
 * Captures a device of the protocol, as lines of a capture file (docs/hid-protocol.md). It first
 * only reads, then sends zero forces, and then sends nothing for longer than the device's watchdog
 * waits.
 */
std::string captureDevice(const Link& link, const Listed& listed, Trace& trace);

}  // namespace palpate::hid

#endif
