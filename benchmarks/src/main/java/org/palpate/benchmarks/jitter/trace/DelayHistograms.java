package org.palpate.benchmarks.jitter.trace;

import org.HdrHistogram.Histogram;

/**
 * The histograms of an experiment, ns.
 *
 * @param lateness time from a deadline to the start of its frame, as measured
 * @param corrected the lateness with the frames that a delayed loop omitted (coordinated omission),
 *     by the correction of HdrHistogram
 * @param period time from the start of a frame to the start of the next
 * @param work duration of the frames' work
 * @param omitted number of deadlines without a frame of their own, because the loop was delayed
 * @param overOneAndAHalfMillis number of periods longer than 1.5 ms
 * @param overTenMillis number of periods longer than 10 ms
 */
public record DelayHistograms(
    Histogram lateness,
    Histogram corrected,
    Histogram period,
    Histogram work,
    long omitted,
    long overOneAndAHalfMillis,
    long overTenMillis) {

  private static final int DIGITS = 3;
  private static final long ONE_AND_A_HALF_MILLIS = 1_500_000;
  private static final long TEN_MILLIS = 10_000_000;

  /**
   * Returns the histograms of the samples.
   *
   * @param periodNanos the time between two deadlines
   */
  public static DelayHistograms of(Samples samples, long periodNanos) {
    Histogram lateness = new Histogram(DIGITS);
    Histogram period = new Histogram(DIGITS);
    Histogram work = new Histogram(DIGITS);
    long omitted = 0;
    long overOneAndAHalf = 0;
    long overTen = 0;
    for (int i = 0; i < samples.count(); i++) {
      lateness.recordValue(Math.max(0, samples.lateness(i)));
      work.recordValue(Math.max(0, samples.work(i)));
      if (i > 0) {
        long nanos = samples.start(i) - samples.start(i - 1);
        period.recordValue(Math.max(0, nanos));
        omitted += (samples.due(i) - samples.due(i - 1)) / periodNanos - 1;
        overOneAndAHalf += nanos > ONE_AND_A_HALF_MILLIS ? 1 : 0;
        overTen += nanos > TEN_MILLIS ? 1 : 0;
      }
    }
    Histogram corrected = lateness.copyCorrectedForCoordinatedOmission(periodNanos);
    return new DelayHistograms(
        lateness, corrected, period, work, omitted, overOneAndAHalf, overTen);
  }
}
