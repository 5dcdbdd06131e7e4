#ifndef PALPATE_FAKE_DEVICE_H
#define PALPATE_FAKE_DEVICE_H

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "palpate_device.h"

/**
 * A hand-built device without the device: the example firmware behind a socket, where the
 * substitute of hidapi finds it. Connections are taken by a thread of its own; reports go when
 * step() is called, on one thread.
 */
class FakeDevice {
 public:
  /** How hidapi lists a device with our protocol: vendor, product, usage page, usage. */
  static constexpr const char* kOurs = "1209-4a01-ff00-50";

  FakeDevice(const std::string& folder, const std::string& serial, const char* kind = kOurs,
             const palpate_capabilities& can = capabilities());
  ~FakeDevice();
  FakeDevice(const FakeDevice&) = delete;
  FakeDevice& operator=(const FakeDevice&) = delete;

  static palpate_capabilities capabilities();

  /** Whether a host has the device open. */
  bool isOpen() const { return incoming_.load() >= 0 || data_ >= 0; }

  /**
   * Sends one report with the pose as it is; `nowMicros` is the device's clock. False where no host
   * has it open, or one that has not read for so long that there is no room.
   */
  bool step(uint32_t nowMicros);

  /** Sends bytes of any kind; as step. */
  bool sendRaw(const std::vector<uint8_t>& bytes);

  /** Reports that were dropped because there was no room for them. */
  int64_t withoutRoom() const { return withoutRoom_; }

  /** The next report as step would send it, without sending it. */
  std::vector<uint8_t> nextReport(uint32_t nowMicros);

  /** Takes what the host has sent; the number of reports. */
  int receive(uint32_t nowMicros);

  /** What the motors do now. */
  palpate_motors motors(uint32_t nowMicros);

  void unplug();

  palpate_pose pose = {};
  palpate_device firmware = {};
  std::vector<uint8_t> lastOut;
  /** Told of every report of full length that comes, on the thread that receives. */
  std::function<void(const uint8_t*)> heard;

 private:
  int socketNow();
  void acceptAll();
  void answer(int connection);

  std::string path_;
  int listener_;
  int data_ = -1;  // the thread that steps
  int64_t withoutRoom_ = 0;
  std::atomic<int> incoming_{-1};  // from the acceptor to it
  std::atomic<bool> ending_{false};
  uint8_t feature_[PALPATE_CAPABILITIES_BYTES] = {};
  std::thread acceptor_;
};

#endif
