package org.palpate.force;

import org.palpate.geometry.Vec3;

/**
 * The mass of what the hand holds.
 *
 * @param kg the mass, positive and finite
 * @param gravityMmPerSecond2 the acceleration of gravity, mm/s^2; zero for none
 */
public record MassSettings(double kg, Vec3 gravityMmPerSecond2) {
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
}
