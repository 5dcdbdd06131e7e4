package org.palpate.benchmarks.stability;

import java.util.Arrays;

/**
 * The bounding box of the handle's motion during an interval of time. A rotation counts as the path
 * at the grip radius.
 */
final class HandleExcursion {
  private static final double MM_PER_M = 1e3;

  private final double fromSeconds;
  private final double toSeconds;
  private final double[] lowest;
  private final double[] highest;

  HandleExcursion(double fromSeconds, double toSeconds, int axes) {
    this.fromSeconds = fromSeconds;
    this.toSeconds = toSeconds;
    lowest = new double[axes];
    highest = new double[axes];
    Arrays.fill(lowest, Double.MAX_VALUE);
    Arrays.fill(highest, -Double.MAX_VALUE);
  }

  /** Extends the box if the time lies in the interval. */
  void record(double seconds, double[] state) {
    if (seconds <= fromSeconds || seconds > toSeconds) {
      return;
    }
    for (int axis = 0; axis < lowest.length; axis++) {
      double mm = state[axis] * (axis < HandleMotion.TRANSLATIONS ? MM_PER_M : Grip.RADIUS_MM);
      lowest[axis] = Math.min(lowest[axis], mm);
      highest[axis] = Math.max(highest[axis], mm);
    }
  }

  /** Returns the diagonal of the box, mm. */
  double excursionMm() {
    double square = 0;
    for (int axis = 0; axis < lowest.length; axis++) {
      double edge = highest[axis] - lowest[axis];
      square += edge * edge;
    }
    return Math.sqrt(square);
  }
}
