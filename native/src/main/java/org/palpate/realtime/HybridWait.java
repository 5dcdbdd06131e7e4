package org.palpate.realtime;

import java.util.function.LongSupplier;
import org.palpate.realtime.os.PreciseSleep;
import org.palpate.realtime.os.Throttling;

/**
 * Sleeps until shortly before the deadline, then spins. The processor is free most of the time, and
 * the wake-up is as punctual as that of a spin.
 *
 * <p>A gap between two clock readings of the spin shows that the thread lost its processor. A gap
 * about as long as the kernel's forced rest of real-time threads counts as throttling.
 *
 * <p>If frames leave less time for sleep than the kernel asks of a real-time thread, as at 10 kHz,
 * the wait sleeps in some of them instead of spinning; see {@link RestBudget}.
 */
public final class HybridWait implements DeadlineWait {
  private final PreciseSleep sleep;
  private final long windowNanos;
  private final long throttlingGapNanos;
  private final RestBudget rest;
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
    rest = new RestBudget(throttling);
    this.clock = clock;
  }

  /** Waits. Sleeps past the deadline if the thread owes the kernel much sleep. */
  @Override
  public void awaitUntil(long deadlineNanos) {
    long before = clock.getAsLong();
    long wake = Math.max(deadlineNanos - windowNanos, rest.wakeNanos(before, deadlineNanos));
    if (before < wake && !Thread.currentThread().isInterrupted()) {
      sleep.until(wake);
      before = clock.getAsLong();
      rest.slept(before);
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

  /** Returns the time before a deadline at which the sleep ends, ns. */
  public long windowNanos() {
    return windowNanos;
  }

  /** Returns the longest gap between two clock readings of a spin so far, ns. */
  public long longestGapNanos() {
    return longestGapNanos;
  }

  /** Returns the number of gaps that were as long as the kernel's forced rest. */
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
