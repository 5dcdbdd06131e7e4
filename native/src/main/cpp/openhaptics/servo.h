#ifndef PALPATE_OPENHAPTICS_SERVO_H
#define PALPATE_OPENHAPTICS_SERVO_H

#include <atomic>

#include "device/device.h"
#include "device/latest.h"
#include "openhaptics/hdapi.h"

namespace palpate::openhaptics {

/** The reading of one tick of the servo loop. */
struct Reading {
  Sample sample;
  Error error = kSuccess;
  int64_t tick = 0;
  int64_t failures = 0;  // ticks with an error so far
  bool fatal = false;
};

/**
 * Our callback in the vendor's servo loop. Each tick runs one frame on the vendor's thread: it
 * reads the device and sets the newest force. It is a watchdog too: without an order for
 * kSilenceNanos the force is zero. It exchanges data without locks and never waits.
 */
class Servo {
 public:
  static constexpr int64_t kSilenceNanos = 20000000;
  /** The number of successive ticks with an error that ends the session. */
  static constexpr int kMostFailures = 25;

  Servo(HdApi& api, DeviceHandle device, bool hasTorque)
      : api_(api), device_(device), hasTorque_(hasTorque) {}

  /** The callback of the vendor's scheduler; `servo` is a Servo. */
  static unsigned PALPATE_HD_CALL tick(void* servo);

  /**
   * Takes the newest reading; returns false if there is none since the last call. Haptic thread.
   */
  bool take(Reading& dest) { return readings_.take(dest); }

  /** Sets the wrench from the next tick on. Haptic thread. */
  void order(const Wrench& wrench) { orders_.publish(wrench); }

  /** Makes the next tick the last one, which sends zero. Any thread. */
  void end() { ending_.store(true); }

  /** Sends zero force in a frame of its own, after the scheduler has stopped. */
  void sendZero();

  /** Whether the last tick has sent zero force. */
  bool hasSentZero() const { return zeroSent_.load(); }

  /** Returns the vendor's call that the servo thread is in, or nullptr. Any thread. */
  const char* call() const { return trace_.call(); }

 private:
  unsigned run();
  void readState(Sample& sample);
  void setForce(const Wrench& wrench);
  void drainErrors(Reading& reading);
  Wrench newestOrder(int64_t nowNanos);

  HdApi& api_;
  const DeviceHandle device_;
  const bool hasTorque_;
  Trace trace_;
  Latest<Reading> readings_;
  Latest<Wrench> orders_;
  std::atomic<bool> ending_{false};
  std::atomic<bool> zeroSent_{false};
  // The members below belong to the vendor's thread.
  Wrench current_;
  int64_t heardNanos_ = 0;
  int64_t ticks_ = 0;
  int64_t failures_ = 0;
  int failuresInARow_ = 0;
  double heat_ = 0;
  bool hasSwitch_ = false;  // the safety switch has been held once
};

}  // namespace palpate::openhaptics

#endif
