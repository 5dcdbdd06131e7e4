package org.palpate.realtime;

/** Calls {@code Thread.sleep} until the deadline has passed. */
final class SleepWait implements DeadlineWait {
  private static final int NANOS_PER_MILLI = 1_000_000;

  @Override
  public void awaitUntil(long deadlineNanos) {
    long rest;
    while ((rest = deadlineNanos - System.nanoTime()) > 0) {
      try {
        Thread.sleep(rest / NANOS_PER_MILLI, (int) (rest % NANOS_PER_MILLI));
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return;
      }
    }
  }

  @Override
  public String toString() {
    return "sleep";
  }
}
