package org.palpate.loop;

/** A clock that a test sets. A wait moves it to the deadline. */
public final class ManualClock implements NanoClock, Pacer {
  /** A millisecond in nanoseconds. */
  public static final long MS = 1_000_000;

  long nowNanos = 5 * MS;
  long wakeUpLateNanos;

  @Override
  public long nanoTime() {
    return nowNanos;
  }

  @Override
  public void awaitUntil(long deadlineNanos) {
    nowNanos = Math.max(nowNanos, deadlineNanos) + wakeUpLateNanos;
    wakeUpLateNanos = 0;
  }
}
