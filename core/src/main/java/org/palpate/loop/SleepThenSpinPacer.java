package org.palpate.loop;

import java.util.concurrent.locks.LockSupport;

/**
 * Sleeps until shortly before the deadline, then spins. It costs up to {@link #DEFAULT_SPIN_NANOS}
 * of a processor a frame, and is late only if the sleep was.
 */
public final class SleepThenSpinPacer implements Pacer {
  /** The usual time to spin, because a sleep often wakes up this late. */
  public static final long DEFAULT_SPIN_NANOS = 150_000;

  private final NanoClock clock;
  private final long spinNanos;

  /** Makes a pacer on the machine's clock that spins for the usual time. */
  public SleepThenSpinPacer() {
    this(NanoClock.SYSTEM, DEFAULT_SPIN_NANOS);
  }

  /**
   * Makes a pacer.
   *
   * @param clock the clock of the deadlines
   * @param spinNanos time before each deadline for which it spins
   */
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
