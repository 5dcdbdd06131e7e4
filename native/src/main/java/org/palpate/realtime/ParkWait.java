package org.palpate.realtime;

import java.util.concurrent.locks.LockSupport;

/** Parks until the moment has come. */
final class ParkWait implements DeadlineWait {
  @Override
  public void until(long nanoTime) {
    long rest;
    while ((rest = nanoTime - System.nanoTime()) > 0) {
      LockSupport.parkNanos(rest);
    }
  }
}
