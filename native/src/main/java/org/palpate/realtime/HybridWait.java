package org.palpate.realtime;

import java.util.function.LongSupplier;
import org.palpate.realtime.os.PreciseSleep;
import org.palpate.realtime.os.Throttling;

/**
 * Sleeps to a little before the moment, then spins: the processor is free most of the time and the
 * wake-up is as punctual as a spin.
 *
 * <p>A spin that jumps tells that the thread was put off its processor; a jump as long as the
 * kernel's forced rest of real-time threads is counted as throttling.
 */
public final class HybridWait implements DeadlineWait {
  private final PreciseSleep sleep;
  private final long windowNanos;
  private final long throttlingGapNanos;
  private final LongSupplier clock;
  private long longestGapNanos;
  private long throttled;

  HybridWait(PreciseSleep sleep, long windowNanos, Throttling throttling) {
    this(sleep, windowNanos, throttling, System::nanoTime);
  }

  HybridWait(PreciseSleep sleep, long windowNanos, Throttling throttling, LongSupplier clock) {
    this.sleep = sleep;
    this.windowNanos = windowNanos;
    this.throttlingGapNanos = throttling.gapNanos();
    this.clock = clock;
  }

  @Override
  public void awaitUntil(long deadlineNanos) {
    long before = clock.getAsLong();
    if (before < deadlineNanos - windowNanos && !Thread.currentThread().isInterrupted()) {
      sleep.until(deadlineNanos - windowNanos);
      before = clock.getAsLong();
    }
    while (before < deadlineNanos && !Thread.currentThread().isInterrupted()) {
      Thread.onSpinWait();
      long now = clock.getAsLong();
      recordGap(now - before);
      before = now;
    }
  }

  private void recordGap(long gapNanos) {
    if (gapNanos > longestGapNanos) {
      longestGapNanos = gapNanos;
    }
    if (gapNanos >= throttlingGapNanos) {
      throttled++;
    }
  }

  /** How long before the moment the sleep ends. */
  public long windowNanos() {
    return windowNanos;
  }

  /** The longest that two looks at the clock lay apart in a spin. */
  public long longestGapNanos() {
    return longestGapNanos;
  }

  /** How often a gap was as long as the rest that the kernel forces on real-time threads. */
  public long throttled() {
    return throttled;
  }

  @Override
  public String toString() {
    return "hybrid, spins " + windowNanos / 1000 + " us";
  }

  @Override
  public void close() {
    sleep.close();
  }
}
