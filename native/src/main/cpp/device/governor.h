#ifndef PALPATE_DEVICE_GOVERNOR_H
#define PALPATE_DEVICE_GOVERNOR_H

#include "device/device.h"

namespace palpate {

/**
 * The last word on a force before it leaves: finite, within the device's nominal maximum and, over
 * time, within its continuous one; rising no faster than the slew; nothing until the hand has held
 * the device still; nothing while samples stay away. Pure: time comes in, one thread.
 */
class Governor {
 public:
  /** A hand holds still while the device stays within this much of one place ... */
  static constexpr double kStillMm = 2;
  /** ... for this long; then the force is let in over kSoftStartNanos. */
  static constexpr int64_t kStillNanos = 200000000;
  static constexpr int64_t kSoftStartNanos = 500000000;
  /** Without a new sample for so long (or three report intervals) the force is zero ... */
  static constexpr int64_t kStaleNanos = 20000000;
  /** ... and let back in over this long. */
  static constexpr int64_t kReturnNanos = 100000000;
  /** From zero to the nominal maximum takes at least this long. */
  static constexpr double kFullSlewSeconds = 0.005;
  /** How fast the motors' heat follows the square of the force. */
  static constexpr double kHeatSeconds = 5;

  explicit Governor(const Specification& specification);

  /** Takes note of a read: whether it was new, where the device is, whether it can push. */
  void sampled(bool fresh, const Sample& sample, int64_t nowNanos);

  /** Writes into `dest` the most of `wanted` that may be felt now. */
  void limit(const Wrench& wanted, int64_t nowNanos, Wrench& dest);

  /** Whether the soft start still waits for the hand. */
  bool isWaitingForHand() const { return waiting_; }

  /** The force that may be asked for now without harm to the motors, N. */
  double heatLimitNewton() const;

 private:
  void followHand(const Sample& sample, int64_t nowNanos);
  void returnOver(int64_t rampNanos, int64_t nowNanos);
  double share(int64_t nowNanos);
  void clampForce(const double (&wanted)[3], double share, double seconds, double (&dest)[3]);
  void slew(double seconds, double (&force)[3]);

  const double nominalNewton_;
  const double continuousNewton_;
  const double nominalTorque_;
  const int64_t staleNanos_;
  bool waiting_ = true;
  bool anchored_ = false;
  bool everLimited_ = false;
  bool stale_ = true;
  double anchorMm_[3] = {0, 0, 0};
  int64_t anchoredNanos_ = 0;
  int64_t freshNanos_ = 0;
  int64_t rampFromNanos_ = 0;
  int64_t rampNanos_ = 1;
  int64_t limitedNanos_ = 0;
  double heatNewton2_ = 0;
  double lastForce_[3] = {0, 0, 0};
};

}  // namespace palpate

#endif
