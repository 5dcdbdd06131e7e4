package org.palpate.device;

/**
 * The capabilities of a device, as its maker states them.
 *
 * @param name name for the user
 * @param serial distinguishes two devices of a kind; empty if the device has none
 * @param maxForceNewton nominal maximum; 0 for a device without force, infinity for one without a
 *     limit
 * @param maxStiffnessNewtonPerMm largest stiffness that the device renders stably, N per mm of its
 *     own motion
 * @param workspaceRadiusMm radius of the ball that the probe reaches
 * @param reportIntervalNanos usual time between samples; 0 if every read is a sample
 * @param hasOrientation whether samples carry the orientation of the probe
 * @param maxTorqueNewtonMm nominal maximum, N mm; 0 for a device without torque, infinity for one
 *     without a limit
 */
public record DeviceSpecification(
    String name,
    String serial,
    double maxForceNewton,
    double maxStiffnessNewtonPerMm,
    double workspaceRadiusMm,
    long reportIntervalNanos,
    boolean hasOrientation,
    double maxTorqueNewtonMm) {
  /** Fraction of the largest stiffness that leaves a margin for grips and for other masses. */
  private static final double DEFAULT_STIFFNESS_FRACTION = 0.5;

  /**
   * Makes the specification of a device that has neither orientation nor torque.
   *
   * @param name name for the user
   * @param serial distinguishes two devices of a kind; empty if the device has none
   * @param maxForceNewton nominal maximum; 0 for a device without force, infinity for one without a
   *     limit
   * @param maxStiffnessNewtonPerMm largest stiffness that the device renders stably, N per mm of
   *     its own motion
   * @param workspaceRadiusMm radius of the ball that the probe reaches
   * @param reportIntervalNanos usual time between samples; 0 if every read is a sample
   */
  public DeviceSpecification(
      String name,
      String serial,
      double maxForceNewton,
      double maxStiffnessNewtonPerMm,
      double workspaceRadiusMm,
      long reportIntervalNanos) {
    this(
        name,
        serial,
        maxForceNewton,
        maxStiffnessNewtonPerMm,
        workspaceRadiusMm,
        reportIntervalNanos,
        false,
        0);
  }

  /** {@return half of the largest stiffness, with which contact is stable, N/mm} */
  public double defaultStiffnessNewtonPerMm() {
    return DEFAULT_STIFFNESS_FRACTION * maxStiffnessNewtonPerMm;
  }
}
