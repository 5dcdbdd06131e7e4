package org.palpate.benchmarks.stability;

import org.palpate.geometry.Vec3;

/**
 * What the person wants: to go from a place above the surface to one below it, stay, and come back.
 *
 * @param awayMm where it starts and ends
 * @param pressedMm where the hand would be if nothing were in its way
 * @param inSeconds how long the way in takes, and the way out
 * @param staySeconds how long it stays
 */
public record Reach(Vec3 awayMm, Vec3 pressedMm, double inSeconds, double staySeconds) {

  public double endSeconds() {
    return 2 * inSeconds + staySeconds;
  }

  /** When the stay ends. */
  public double leaveSeconds() {
    return inSeconds + staySeconds;
  }

  /** Where along the way the hand wants to be, 0 away and 1 pressed, with least jerk. */
  public double share(double seconds) {
    if (seconds <= inSeconds) {
      return eased(Math.max(0, seconds) / inSeconds);
    }
    return seconds <= leaveSeconds() ? 1 : eased(Math.max(0, (endSeconds() - seconds) / inSeconds));
  }

  /** The change of {@link #share} a second. */
  public double shareRate(double seconds) {
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
