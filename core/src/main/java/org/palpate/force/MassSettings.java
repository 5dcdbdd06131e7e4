package org.palpate.force;

import org.palpate.geometry.Vec3;

/**
 * The mass of what the hand holds, and the rules by which it moves in a frame.
 *
 * @param kg the mass, positive and finite
 * @param gravityMmPerSecond2 the acceleration of gravity, mm/s^2; zero for none
 */
public record MassSettings(double kg, Vec3 gravityMmPerSecond2) {
  /** A step shorter than this counts as rest, mm. */
  static final double REST_MM = 1e-9;

  /** The drag, as a fraction of the critical damping of the spring to the device. */
  static final double DAMPING_RATIO = 0.2;

  private static final double MAX_STEP_SECONDS = 0.005;
  private static final double NANOS_PER_SECOND = 1e9;

  /** A mass in N s^2/mm for each kg. */
  private static final double UNITS_PER_KG = 1e-3;

  /**
   * Checks the ranges.
   *
   * @throws IllegalArgumentException if the mass is not positive or a number is not finite
   */
  public MassSettings {
    if (!(kg > 0 && kg < Double.POSITIVE_INFINITY) || !gravityMmPerSecond2.isFinite()) {
      throw new IllegalArgumentException(
          "mass must be positive and gravity finite: kg="
              + kg
              + " gravityMmPerSecond2="
              + gravityMmPerSecond2);
    }
  }

  /** Returns the time by which the mass moves in a frame, s: at most 5 ms. */
  static double stepSeconds(long elapsedNanos) {
    return Math.min(MAX_STEP_SECONDS, Math.max(0, elapsedNanos) / NANOS_PER_SECOND);
  }

  /** Returns the mass, N s^2/mm. */
  double newtonSecond2PerMm() {
    return kg * UNITS_PER_KG;
  }

  /** Returns the weight, N. */
  Vec3 weightNewton() {
    return gravityMmPerSecond2.mul(newtonSecond2PerMm(), new Vec3());
  }

  /** Returns the drag on a spring to the device, N s/mm. */
  double dragNewtonSecondPerMm(double stiffnessNewtonPerMm) {
    return 2 * DAMPING_RATIO * Math.sqrt(stiffnessNewtonPerMm * newtonSecond2PerMm());
  }
}
