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
 * A fake hand-built device: the example firmware behind a socket that the substitute of hidapi
 * finds. A thread of its own accepts connections. Each call of step() sends a report; one thread
 * calls it.
 */
class FakeDevice {
 public:
  /** The vendor, product, usage page and usage with which hidapi lists a device of our protocol. */
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
   * Sends one report with the present pose; `nowMicros` is the device's clock. Returns false if no
   * host has the device open, or if the host reads so slowly that there is no room.
   */
  bool step(uint32_t nowMicros);

  /** Sends any bytes, and returns what step returns. */
  bool sendRaw(const std::vector<uint8_t>& bytes);

  /** Returns the number of reports that were dropped because there was no room for them. */
  int64_t withoutRoom() const { return withoutRoom_; }

  /** Returns the next report that step would send, without sending it. */
  std::vector<uint8_t> nextReport(uint32_t nowMicros);

  /** Takes the reports that the host has sent, and returns their number. */
  int receive(uint32_t nowMicros);

  /** Returns the force and torque that the motors exert now. */
  palpate_motors motors(uint32_t nowMicros);

  void unplug();

  palpate_pose pose = {};
  palpate_device firmware = {};
  std::vector<uint8_t> lastOut;
  /** Receives every report of full length from the host, on the thread that calls receive(). */
  std::function<void(const uint8_t*)> heard;

 private:
  int socketNow();
  void acceptAll();
  void answer(int connection);

  std::string path_;
  int listener_;
  int data_ = -1;  // for the thread that calls step()
  int64_t withoutRoom_ = 0;
  std::atomic<int> incoming_{-1};  // from the accepting thread to it
  std::atomic<bool> ending_{false};
  uint8_t feature_[PALPATE_CAPABILITIES_BYTES] = {};
  std::thread acceptor_;
};

#endif
