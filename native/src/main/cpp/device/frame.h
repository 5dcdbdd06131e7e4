#ifndef PALPATE_DEVICE_FRAME_H
#define PALPATE_DEVICE_FRAME_H

#include <cstddef>
#include <cstdint>

namespace palpate {

/** Bits of Sample::flags. */
enum SampleFlag : uint32_t {
  /**
   * The device is powered and calibrated, and its safety switch is held: a force that is sent
   * reaches the hand.
   */
  kForceReady = 1U << 0,
  /** The soft start waits until the hand holds the device still. */
  kWaitingForHand = 1U << 1,
  /** The device must be calibrated first. */
  kNeedsCalibration = 1U << 2,
  /** The motors are hot. */
  kMotorsHot = 1U << 3,
  /** The device's own watchdog has set the force to zero since the previous sample. */
  kWatchdogTripped = 1U << 4,
};

/**
 * One sample, as the device sent it: a position may be NaN.
 *
 * Device frame of every back end: x to the right, y up, z towards the person; millimetres.
 */
struct Sample {
  int64_t timeNanos = 0;  // on the device's own clock
  double positionMm[3] = {0, 0, 0};
  double orientation[4] = {0, 0, 0, 1};  // unit quaternion x, y, z, w
  uint32_t buttons = 0;                  // bit 0 is the first
  uint32_t flags = kForceReady;
  double gripperMm = 0;
  double motorHeat = 0;  // from 0, cold, to 1, the maker's limit
};

/** The force and the torque that the hand is to feel, device frame. */
struct Wrench {
  double forceNewton[3] = {0, 0, 0};
  double torqueNewtonMetre[3] = {0, 0, 0};
  double gripperNewton = 0;
};

/** Counters of the samples. The haptic thread alone writes them. */
struct Counters {
  int64_t samples = 0;
  int64_t merged = 0;       // replaced by a newer one before they were read
  int64_t late = 0;         // came after more than two report intervals
  int64_t lost = 0;         // gaps in the device's sequence
  int64_t duplicated = 0;   // the same sequence number again
  int64_t outOfOrder = 0;   // older than the previous one: dropped
  int64_t wrongLength = 0;  // dropped
  int64_t errors = 0;       // failed vendor's calls that the session survived
};

/**
 * The bytes that C++ and Java share, one block a device, native byte order.
 *
 *   0        8              32              64      68    72      80      88 .. 127
 *   | time i64 | position 3 f64 | quaternion 4 f64 | buttons | flags | gripper | heat | unused |
 *   128            152            176       184      192 .. 255
 *   | force 3 f64 | torque 3 f64 | gripper | unused | counters 8 i64 |
 */
struct alignas(64) Frame {
  Sample sample;
  char unusedAfterSample[128 - sizeof(Sample)];
  Wrench wrench;
  char unusedAfterWrench[64 - sizeof(Wrench)];
  Counters counters;
};

static_assert(offsetof(Sample, positionMm) == 8, "layout is shared with FrameLayout.java");
static_assert(offsetof(Sample, orientation) == 32, "layout is shared with FrameLayout.java");
static_assert(offsetof(Sample, buttons) == 64, "layout is shared with FrameLayout.java");
static_assert(offsetof(Sample, flags) == 68, "layout is shared with FrameLayout.java");
static_assert(offsetof(Sample, gripperMm) == 72, "layout is shared with FrameLayout.java");
static_assert(offsetof(Sample, motorHeat) == 80, "layout is shared with FrameLayout.java");
static_assert(offsetof(Frame, wrench) == 128, "layout is shared with FrameLayout.java");
static_assert(offsetof(Frame, counters) == 192, "layout is shared with FrameLayout.java");
static_assert(sizeof(Frame) == 256, "layout is shared with FrameLayout.java");

}  // namespace palpate

#endif
