package org.palpate.assess;

import org.palpate.geometry.Vec3;

/**
 * The path of a position, and its means over intervals of equal length. A path through the means
 * does not depend on the rate of the frames, and less on the resolution of a device than one
 * through every sample.
 *
 * <p>An interval without a sample gets a position on the straight line between its neighbours,
 * unless the gap is longer than {@link #LONGEST_GAP_SECONDS}. Times never run backward.
 *
 * <p>One thread.
 */
final class SteadyPath {
  /** The length of an interval, s. */
  static final double INTERVAL_SECONDS = 0.004;

  /** A hand may move in any way in a longer gap. */
  static final double LONGEST_GAP_SECONDS = 0.25;

  private static final long LONGEST_GAP = Math.round(LONGEST_GAP_SECONDS / INTERVAL_SECONDS);

  private final Sink sink;
  private final Vec3 sum = new Vec3();
  private final Vec3 mean = new Vec3();
  private final Vec3 between = new Vec3();
  private final Vec3 end = new Vec3();
  private final Vec3 latest = new Vec3();
  private long interval;
  private int count;
  private long endInterval;
  private boolean hasMean;
  private double lengthMm;

  /** Receives the means. */
  interface Sink {
    /** Ignores all means. */
    Sink NONE = (positionMm, begins) -> {};

    /**
     * Receives the mean of the next interval.
     *
     * @param positionMm belongs to the path and changes with the next mean
     * @param begins whether it follows no mean, or one from before a gap
     */
    void accept(Vec3 positionMm, boolean begins);
  }

  SteadyPath(Sink sink) {
    this.sink = sink;
  }

  /** Adds a position. */
  void add(double seconds, Vec3 positionMm) {
    long now = (long) Math.floor(seconds / INTERVAL_SECONDS);
    if (count > 0 && now > interval) {
      endInterval();
    }
    if (count == 0) {
      interval = now;
      if (!hasMean) {
        end.set(positionMm);
      }
    }
    sum.add(positionMm, sum);
    latest.set(positionMm);
    count++;
  }

  private void endInterval() {
    sum.mul(1.0 / count, mean);
    boolean goesOn = hasMean && interval - endInterval <= LONGEST_GAP;
    for (long n = endInterval + 1; goesOn && n < interval; n++) {
      double fraction = (double) (n - endInterval) / (interval - endInterval);
      mean.sub(end, between).mul(fraction, between).add(end, between);
      sink.accept(between, false);
    }
    lengthMm += mean.sub(end, between).length();
    sink.accept(mean, !goesOn);
    end.set(mean);
    endInterval = interval;
    hasMean = true;
    count = 0;
    sum.set(0, 0, 0);
  }

  /** Ends the piece, so that the next position begins another one. */
  void endPiece() {
    if (count > 0) {
      endInterval();
    }
    if (hasMean) {
      lengthMm += latest.sub(end, between).length();
      hasMean = false;
    }
  }

  /** Returns the length of all pieces that have ended, mm. */
  double lengthMm() {
    return lengthMm;
  }
}
