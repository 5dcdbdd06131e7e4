package org.palpate.realtime;

import java.util.concurrent.locks.LockSupport;

/** Parks until the moment has come. */
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
