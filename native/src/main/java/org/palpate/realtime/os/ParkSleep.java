package org.palpate.realtime.os;

import java.util.concurrent.locks.LockSupport;

/** Sleeps by the JDK's own relative wait, for systems that offer nothing better. */
final class ParkSleep implements PreciseSleep {
  @Override
  public void until(long nanoTime) {
    long rest = nanoTime - System.nanoTime();
    if (rest > 0) {
      LockSupport.parkNanos(rest);
    }
  }
}
