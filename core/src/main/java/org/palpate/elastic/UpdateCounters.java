package org.palpate.elastic;

import org.HdrHistogram.Histogram;

/** Counts updates. The thread of the updates writes; read them after it has ended. */
public final class UpdateCounters {
  private static final long MOST_NANOS = 100_000_000_000L;
  private static final int SIGNIFICANT_DIGITS = 3;
  private static final double NANOS_PER_MILLI = 1e6;

  private final Histogram nanos = new Histogram(MOST_NANOS, SIGNIFICANT_DIGITS);
  private long updates;
  private long skipped;
  private long scaledBack;
  private long refused;
  private long windowless;
  private long elsewhere;
  private double worstResidual;

  void count(boolean wasScaledBack) {
    updates++;
    scaledBack += wasScaledBack ? 1 : 0;
  }

  void countSkipped() {
    skipped++;
  }

  void noteNanos(long duration) {
    nanos.recordValue(Math.max(0, Math.min(MOST_NANOS, duration)));
  }

  void countRefused() {
    refused++;
  }

  void countWindowless() {
    windowless++;
  }

  void countElsewhere() {
    elsewhere++;
  }

  void noteResidual(double relative) {
    worstResidual = Math.max(worstResidual, relative);
  }

  /** {@return the number of updates} */
  public long updates() {
    return updates;
  }

  /** {@return the number of updates that were left out because nothing was pressed or near} */
  public long skipped() {
    return skipped;
  }

  /**
   * {@return a percentile of the time of an update, ms}
   *
   * @param percentile the percentage of updates that take at most this time; 100 for the longest
   */
  public double updateMs(double percentile) {
    return nanos.getValueAtPercentile(percentile) / NANOS_PER_MILLI;
  }

  /** {@return the number of updates that would have folded a cell and were scaled back} */
  public long scaledBack() {
    return scaledBack;
  }

  /** {@return the number of updates that could not be proved and were not used} */
  public long refused() {
    return refused;
  }

  /** {@return the number of updates that could be proved only without the window} */
  public long windowless() {
    return windowless;
  }

  /**
   * {@return the number of recorded loads that a replay did not reach to the bit; 0 if it repeats
   * the session, or if no updates were recorded}
   */
  public long elsewhere() {
    return elsewhere;
  }

  /** {@return the largest residual that an update left, over its load} */
  public double worstResidual() {
    return worstResidual;
  }
}
