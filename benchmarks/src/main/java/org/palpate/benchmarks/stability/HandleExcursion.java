package org.palpate.benchmarks.stability;

import org.palpate.geometry.Vec3;

/** The bounding box of the handle's motion during an interval of time. */
final class HandleExcursion {
  private static final double MM_PER_M = 1e3;
  private static final double MOST = Double.MAX_VALUE;

  private final double fromSeconds;
  private final double toSeconds;
  private final Vec3 lowestMm = new Vec3(MOST, MOST, MOST);
  private final Vec3 highestMm = new Vec3(-MOST, -MOST, -MOST);

  HandleExcursion(double fromSeconds, double toSeconds) {
    this.fromSeconds = fromSeconds;
    this.toSeconds = toSeconds;
  }

  /** Extends the box if the time lies in the interval. */
  void record(double seconds, double[] state) {
    if (seconds <= fromSeconds || seconds > toSeconds) {
      return;
    }
    for (int axis = 0; axis < 3; axis++) {
      double mm = state[HandleMotion.HANDLE + axis] * MM_PER_M;
      lowestMm.set(axis, Math.min(lowestMm.get(axis), mm));
      highestMm.set(axis, Math.max(highestMm.get(axis), mm));
    }
  }

  /** Returns the diagonal of the box, mm. */
  double excursionMm() {
    return highestMm.sub(lowestMm, new Vec3()).length();
  }
}
