package org.palpate.realtime;

import java.util.function.LongSupplier;
import org.HdrHistogram.Histogram;
import org.palpate.realtime.os.PreciseSleep;

/**
 * How long before a deadline a thread must leave its sleep to be on time: found by sleeping and
 * looking how late it wakes, on the machine, in the thread and under the scheduling that it is for.
 */
final class SpinWindow {
  static final long MIN_NANOS = 20_000;
  static final long MAX_NANOS = 400_000;

  private static final int SLEEPS = 200;
  private static final long SLEEP_NANOS =
      900_000; // about a frame's, since an idle processor sleeps deeper the longer it may
  private static final double COVERED_PERCENTILE = 99;
  private static final long LARGEST_NANOS = 10_000_000_000L;

  private SpinWindow() {}

  /** Sleeps for about a fifth of a second; {@link #MAX_NANOS} at most. */
  static long measureNanos(PreciseSleep sleep) {
    return measureNanos(sleep, System::nanoTime);
  }

  static long measureNanos(PreciseSleep sleep, LongSupplier clock) {
    Histogram lateness = new Histogram(LARGEST_NANOS, 3);
    for (int i = 0; i < SLEEPS; i++) {
      long due = clock.getAsLong() + SLEEP_NANOS;
      sleep.until(due);
      lateness.recordValue(Math.min(LARGEST_NANOS, Math.max(0, clock.getAsLong() - due)));
    }
    long covered = lateness.getValueAtPercentile(COVERED_PERCENTILE);
    // A quarter more, since the machine was seen for a moment only.
    return Math.min(MAX_NANOS, Math.max(MIN_NANOS, covered + covered / 4));
  }
}
