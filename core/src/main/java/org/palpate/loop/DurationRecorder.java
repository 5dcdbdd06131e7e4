package org.palpate.loop;

import org.HdrHistogram.AbstractHistogram;
import org.HdrHistogram.Histogram;
import org.HdrHistogram.SingleWriterRecorder;

/**
 * A histogram of times that the haptic thread writes and any other may look at. Recording neither
 * waits nor allocates; times beyond {@link #LONGEST_NANOS} count as that.
 */
final class DurationRecorder {
  static final long LONGEST_NANOS = 100_000_000_000L;
  private static final int DIGITS = 3;

  private final SingleWriterRecorder recorder = new SingleWriterRecorder(LONGEST_NANOS, DIGITS);
  private final Histogram total = new Histogram(LONGEST_NANOS, DIGITS);
  private Histogram interval;

  /** Haptic thread. */
  void record(long nanos) {
    recorder.recordValue(Math.min(Math.max(0, nanos), LONGEST_NANOS));
  }

  /** Everything recorded so far. Any thread but the haptic one. */
  synchronized Quantiles quantiles() {
    return Quantiles.of(total());
  }

  private AbstractHistogram total() {
    interval = recorder.getIntervalHistogram(interval);
    total.add(interval);
    return total;
  }
}
