package org.palpate.realtime;

import java.util.concurrent.locks.LockSupport;

/** Parks the thread until the deadline has passed or the thread is interrupted. */
final class ParkWait implements DeadlineWait {
  @Override
  public void awaitUntil(long deadlineNanos) {
    long rest;
    while ((rest = deadlineNanos - System.nanoTime()) > 0
        && !Thread.currentThread().isInterrupted()) {
      LockSupport.parkNanos(rest);
    }
  }

  @Override
  public String toString() {
    return "park";
  }
}
