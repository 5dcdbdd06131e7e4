package org.palpate.loop;

import org.HdrHistogram.Histogram;
import org.HdrHistogram.SingleWriterRecorder;

/**
 * Records durations in a histogram. Durations beyond {@link #MAX_NANOS} count as that.
 *
 * <p>The haptic thread writes; recording neither waits nor allocates. Any other thread may read.
 */
final class DurationRecorder {
  static final long MAX_NANOS = 100_000_000_000L;
  private static final int SIGNIFICANT_DIGITS = 3;

  private final SingleWriterRecorder recorder =
      new SingleWriterRecorder(MAX_NANOS, SIGNIFICANT_DIGITS);
  private final Histogram total = new Histogram(MAX_NANOS, SIGNIFICANT_DIGITS);
  private Histogram interval;

  /** Records a duration. Haptic thread. */
  void record(long nanos) {
    recorder.recordValue(Math.min(Math.max(0, nanos), MAX_NANOS));
  }

  /** Returns the quantiles of all durations so far. Any thread but the haptic one. */
  synchronized Quantiles quantiles() {
    interval = recorder.getIntervalHistogram(interval);
    total.add(interval);
    return Quantiles.of(total);
  }
}
