#ifndef PALPATE_HID_HID_BACKEND_H
#define PALPATE_HID_HID_BACKEND_H

#include "device/device.h"
#include "hid/hidapi.h"

namespace palpate::hid {

/**
 * Devices that speak HID: hand-built ones with the protocol of docs/hid-protocol.md, WoodenHaptics,
 * and the 3Dconnexion SpaceMouse as an input without force.
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

  /** The caller holds the lock of HidApi. Without a handle, `why` gives the reason. */
  static Opened openHandle(const std::string& id, Trace& trace, std::string& why);
};

/** A device of hidapi's that is closed when it goes out of use. Moves, does not copy. */
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
   * One read without waiting: how many bytes, 0 for none or for a failure that is let pass, -1
   * where so many failed in a row that the device is gone, which `trace` then knows.
   */
  int read(uint8_t* bytes, size_t length, Trace& trace, Counters& counters);

  /** One write; `isGone` is set as for a read. */
  bool write(const uint8_t* bytes, size_t length, Trace& trace, Counters& counters);

  /** Whether the device is gone. */
  bool isGone() const { return gone_; }

  /** Sends the last report until it is taken, three times at most, then lets go. */
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

/** Why a device's node cannot be opened, by the system's error, and what to do: one line. */
std::string refusal(const Listed& listed, int error);

/** Opens a device of each kind over a link; nullptr with `why` filled where it is not one. */
std::unique_ptr<Device> openProtocolDevice(Link link, const Listed& listed,
                                           std::shared_ptr<Trace> trace, std::string& why);
std::unique_ptr<Device> openWoodenHaptics(Link link, const Listed& listed,
                                          std::shared_ptr<Trace> trace, std::string& why);
std::unique_ptr<Device> openSpaceMouse(Link link, const Listed& listed,
                                       std::shared_ptr<Trace> trace, std::string& why);

/**
 * Captures a device of the protocol, as lines of a capture file (docs/hid-protocol.md). It first
 * listens, then sends zero forces, then falls silent for longer than the device's watchdog waits.
 */
std::string captureDevice(const Link& link, const Listed& listed, Trace& trace);

}  // namespace palpate::hid

#endif
