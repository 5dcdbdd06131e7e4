#ifndef PALPATE_DEVICE_GOVERNOR_H
#define PALPATE_DEVICE_GOVERNOR_H

#include "device/device.h"

namespace palpate {

/**
 * Limits each force before it is sent. The result is finite, within the device's nominal maximum
 * and, over time, within its continuous maximum. It rises no faster than the slew rate. It is zero
 * until the hand has held the device still, and while no samples arrive.
 *
 * It has no clock: the caller passes the time. One thread.
 */
class Governor {
 public:
  /** A hand holds the device still if it stays within this distance of one position ... */
  static constexpr double kStillMm = 2;
  /** ... for this time. The force then rises over kSoftStartNanos. */
  static constexpr int64_t kStillNanos = 200000000;
  static constexpr int64_t kSoftStartNanos = 500000000;
  /** After this time, or three report intervals, without a new sample the force is zero ... */
  static constexpr int64_t kStaleNanos = 20000000;
  /** ... and returns over this time once samples arrive again. */
  static constexpr int64_t kReturnNanos = 100000000;
  /** The least time in which the force rises from zero to the nominal maximum. */
  static constexpr double kFullSlewSeconds = 0.005;
  /** The time constant with which the motors' heat follows the square of the force. */
  static constexpr double kHeatSeconds = 5;

  explicit Governor(const Specification& specification);

  /** Takes note of a read: whether the sample is new, its position and its flags. */
  void sampled(bool fresh, const Sample& sample, int64_t nowNanos);

  /** Writes the wanted wrench into `dest`, limited to what is permitted now. */
  void limit(const Wrench& wanted, int64_t nowNanos, Wrench& dest);

  /** Whether the soft start still waits for the hand. */
  bool isWaitingForHand() const { return waiting_; }

  /** Returns the largest force that does not overheat the motors now, N. */
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
