package org.palpate.realtime.os;

import com.sun.jna.Memory;
import com.sun.jna.Pointer;

/**
 * Sleeps with {@code clock_nanosleep} to an absolute time, so that a delay before the call does not
 * delay the wake-up. Relies on {@link System#nanoTime} being CLOCK_MONOTONIC, as in HotSpot on
 * Linux.
 */
final class LinuxSleep implements PreciseSleep {
  private static final long NANOS_PER_SECOND = 1_000_000_000L;

  // struct timespec { long seconds; long nanoseconds; }
  private final Memory request = new Memory(2 * Long.BYTES);
  private final long address = Pointer.nativeValue(request);

  @Override
  public void until(long nanoTime) {
    request.setLong(0, nanoTime / NANOS_PER_SECOND);
    request.setLong(Long.BYTES, nanoTime % NANOS_PER_SECOND);
    LinuxLibrary.clock_nanosleep(
        LinuxLibrary.CLOCK_MONOTONIC, LinuxLibrary.TIMER_ABSTIME, address, 0);
  }

  @Override
  public void close() {
    request.close();
  }
}
