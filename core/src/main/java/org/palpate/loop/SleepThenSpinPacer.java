package org.palpate.loop;

import java.util.concurrent.locks.LockSupport;

/**
 * Sleeps until shortly before the deadline, then spins. Costs up to {@link #DEFAULT_SPIN_NANOS} of
 * a processor a frame and is late only when the sleep was.
 */
public final class SleepThenSpinPacer implements Pacer {
  /** A sleep wakes up this late often enough that the rest is better spun. */
  public static final long DEFAULT_SPIN_NANOS = 150_000;

  private final NanoClock clock;
  private final long spinNanos;

  public SleepThenSpinPacer() {
    this(NanoClock.SYSTEM, DEFAULT_SPIN_NANOS);
  }

  /** Sleeps to {@code spinNanos} before a deadline on {@code clock}. */
  public SleepThenSpinPacer(NanoClock clock, long spinNanos) {
    this.clock = clock;
    this.spinNanos = spinNanos;
  }

  @Override
  public void awaitUntil(long deadlineNanos) {
    long left = deadlineNanos - clock.nanoTime();
    while (left > 0 && !Thread.currentThread().isInterrupted()) {
      if (left > spinNanos) {
        LockSupport.parkNanos(left - spinNanos);
      } else {
        Thread.onSpinWait();
      }
      left = deadlineNanos - clock.nanoTime();
    }
  }
}
