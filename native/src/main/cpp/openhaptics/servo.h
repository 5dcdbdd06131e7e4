#ifndef PALPATE_OPENHAPTICS_SERVO_H
#define PALPATE_OPENHAPTICS_SERVO_H

#include <atomic>

#include "device/device.h"
#include "device/latest.h"
#include "openhaptics/hdapi.h"

namespace palpate::openhaptics {

/** What a tick of the servo loop saw. */
struct Reading {
  Sample sample;
  Error error = kSuccess;
  int64_t tick = 0;
  int64_t failures = 0;  // ticks with an error so far
  bool fatal = false;
};

/**
 * Our part of the vendor's servo loop: one frame a tick on the vendor's thread, which reads the
 * device and sets the newest force. It is its own watchdog: without an order for kSilenceNanos the
 * force is zero. Hands over without locks; nothing here waits.
 */
class Servo {
 public:
  static constexpr int64_t kSilenceNanos = 20000000;
  /** So many ticks in a row with an error end the session. */
  static constexpr int kMostFailures = 25;

  Servo(HdApi& api, DeviceHandle device, bool hasTorque)
      : api_(api), device_(device), hasTorque_(hasTorque) {}

  /** What the vendor's scheduler calls; `servo` is a Servo. */
  static unsigned PALPATE_HD_CALL tick(void* servo);

  /** Haptic thread: the newest tick; false where there was none since. */
  bool take(Reading& dest) { return readings_.take(dest); }

  /** Haptic thread: what the hand is to feel from the next tick on. */
  void order(const Wrench& wrench) { orders_.publish(wrench); }

  /** Any thread: the next tick sends zero and is the last. */
  void end() { ending_.store(true); }

  /** Sends zero in a frame of its own, once the scheduler has stopped. */
  void sendZero();

  /** Whether the last tick has sent its zero. */
  bool hasSentZero() const { return zeroSent_.load(); }

  /** The call that the servo thread is in, or nullptr. Any thread. */
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
  // What follows belongs to the vendor's thread.
  Wrench current_;
  int64_t heardNanos_ = 0;
  int64_t ticks_ = 0;
  int64_t failures_ = 0;
  int failuresInARow_ = 0;
  double heat_ = 0;
  bool hasSwitch_ = false;  // the safety switch was seen held
};

}  // namespace palpate::openhaptics

#endif
