package org.palpate.benchmarks.stability;

import org.palpate.geometry.Vec3;

/**
 * The longest way back of a handle during an interval of time: how far it comes out again from the
 * deepest position so far. A handle that only sinks has none.
 */
final class HandleRebound {
  private static final double MM_PER_M = 1e3;

  private final double fromSeconds;
  private final double toSeconds;
  private final Vec3 inward;
  private double deepestMm = Double.NEGATIVE_INFINITY;
  private double longestMm;

  /**
   * Creates a measure of an interval.
   *
   * @param inward unit direction into the solid
   */
  HandleRebound(double fromSeconds, double toSeconds, Vec3 inward) {
    this.fromSeconds = fromSeconds;
    this.toSeconds = toSeconds;
    this.inward = inward;
  }

  /** Takes the state into account if the time lies in the interval. */
  void record(double seconds, double[] state) {
    if (seconds <= fromSeconds || seconds > toSeconds) {
      return;
    }
    double depthMm = MM_PER_M * (inward.x * state[0] + inward.y * state[1] + inward.z * state[2]);
    deepestMm = Math.max(deepestMm, depthMm);
    longestMm = Math.max(longestMm, deepestMm - depthMm);
  }

  /** Returns the way, mm; infinity if no time lay in the interval. */
  double longestMm() {
    return deepestMm == Double.NEGATIVE_INFINITY ? Double.POSITIVE_INFINITY : longestMm;
  }
}
