package org.palpate.force.guide;

import org.palpate.geometry.Vec3;

/**
 * The spring of a guide. Its pull grows with the distance up to a largest one. If it has a range,
 * it fades from half the range on and is zero beyond the range, so that a distant hand is free.
 *
 * <p>The pull depends on the distance alone, so the spring gives back no more energy than it took.
 * The same serves for rotations, with rad and N mm.
 *
 * @param newtonPerMm pull per distance, at least 0
 * @param maxNewton the largest pull, at least 0
 * @param rangeMm the distance beyond which it does not pull, positive; infinity for none
 */
public record GuideSpring(double newtonPerMm, double maxNewton, double rangeMm) {
  /**
   * Checks the ranges.
   *
   * @throws IllegalArgumentException if a number is out of range
   */
  public GuideSpring {
    if (!(newtonPerMm >= 0 && maxNewton >= 0 && rangeMm > 0)) {
      throw new IllegalArgumentException(
          "stiffness and pull must be at least 0 and the range positive: newtonPerMm="
              + newtonPerMm
              + " maxNewton="
              + maxNewton
              + " rangeMm="
              + rangeMm);
    }
  }

  /**
   * {@return the pull at a distance, N; of a spring of rotations the torque, N mm}
   *
   * @param distanceMm the distance, mm, or the angle, rad; at least 0
   */
  public double newton(double distanceMm) {
    double pull = Math.min(newtonPerMm * distanceMm, maxNewton);
    double fading = 2 - 2 * distanceMm / rangeMm;
    return fading < 1 ? pull * Math.max(0, fading) : pull;
  }

  /** Adds the pull along an offset from the hand to where it should be. */
  void pull(Vec3 offsetMm, Vec3 forceNewton) {
    double distance = offsetMm.length();
    if (distance > 0) {
      double factor = newton(distance) / distance;
      forceNewton.x += factor * offsetMm.x;
      forceNewton.y += factor * offsetMm.y;
      forceNewton.z += factor * offsetMm.z;
    }
  }
}
