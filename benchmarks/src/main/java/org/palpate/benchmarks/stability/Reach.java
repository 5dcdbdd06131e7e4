package org.palpate.benchmarks.stability;

import org.palpate.geometry.Vec3;

/**
 * The intended motion of the person: from a position above the surface to one below it and back.
 *
 * @param awayMm the start and the end
 * @param pressedMm the target, which the hand would reach without contact
 * @param inSeconds the duration of the motion in each direction
 * @param staySeconds the duration of the stay
 */
public record Reach(Vec3 awayMm, Vec3 pressedMm, double inSeconds, double staySeconds) {

  /** Returns the unit direction of the motion into the solid. */
  Vec3 inward() {
    Vec3 way = pressedMm.sub(awayMm, new Vec3());
    return way.mul(1 / way.length(), way);
  }

  /** Returns the time at which the motion ends. */
  public double endSeconds() {
    return 2 * inSeconds + staySeconds;
  }

  /** Returns the time at which the stay ends. */
  public double leaveSeconds() {
    return inSeconds + staySeconds;
  }

  /** Returns the intended fraction of the motion, 0 away and 1 pressed, with minimal jerk. */
  public double fraction(double seconds) {
    if (seconds <= inSeconds) {
      return eased(Math.max(0, seconds) / inSeconds);
    }
    return seconds <= leaveSeconds() ? 1 : eased(Math.max(0, (endSeconds() - seconds) / inSeconds));
  }

  /** Returns the derivative of {@link #fraction} by time. */
  public double fractionRate(double seconds) {
    if (seconds <= 0 || seconds >= endSeconds()) {
      return 0;
    }
    if (seconds <= inSeconds) {
      return easedRate(seconds / inSeconds) / inSeconds;
    }
    return seconds <= leaveSeconds()
        ? 0
        : -easedRate((endSeconds() - seconds) / inSeconds) / inSeconds;
  }

  private static double eased(double t) {
    return t * t * t * (10 + t * (6 * t - 15));
  }

  private static double easedRate(double t) {
    return 30 * t * t * (1 - t) * (1 - t);
  }
}
