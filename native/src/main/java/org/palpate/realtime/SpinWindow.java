package org.palpate.realtime;

import java.util.function.LongSupplier;
import org.HdrHistogram.Histogram;
import org.palpate.realtime.os.PreciseSleep;

/**
 * Measures the time before a deadline at which a thread must end its sleep to be punctual. It
 * sleeps repeatedly and records the lateness of each wake-up, in the thread and under the
 * scheduling that the result is for.
 */
final class SpinWindow {
  static final long MIN_NANOS = 20_000;
  static final long MAX_NANOS = 400_000;

  private static final int SLEEPS = 200;
  // About the length of a frame: an idle processor enters deeper sleep states the longer it rests.
  private static final double SLEEP_OVER_PERIOD = 0.9;
  private static final double COVERED_PERCENTILE = 99;
  private static final long LARGEST_NANOS = 10_000_000_000L;

  private SpinWindow() {}

  /** Measures for about 200 periods; returns at most {@link #MAX_NANOS}. */
  static long measureNanos(PreciseSleep sleep, long periodNanos) {
    return measureNanos(sleep, periodNanos, System::nanoTime);
  }

  static long measureNanos(PreciseSleep sleep, long periodNanos, LongSupplier clock) {
    long sleepNanos = (long) (SLEEP_OVER_PERIOD * periodNanos);
    Histogram lateness = new Histogram(LARGEST_NANOS, 3);
    for (int i = 0; i < SLEEPS; i++) {
      long due = clock.getAsLong() + sleepNanos;
      sleep.until(due);
      lateness.recordValue(Math.min(LARGEST_NANOS, Math.max(0, clock.getAsLong() - due)));
    }
    long covered = lateness.getValueAtPercentile(COVERED_PERCENTILE);
    // A quarter is added because the measurement sees the machine only briefly.
    return Math.min(MAX_NANOS, Math.max(MIN_NANOS, covered + covered / 4));
  }
}
