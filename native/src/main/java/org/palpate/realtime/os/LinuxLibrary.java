package org.palpate.realtime.os;

import com.sun.jna.Native;

/**
 * Binds the calls of the C library directly. Addresses are {@code long} values, so that a call in a
 * frame creates no object. 64-bit systems only.
 *
 * <p>Source: sched.h, sys/mman.h, sys/prctl.h, time.h of Linux.
 */
final class LinuxLibrary {
  static final int SCHED_FIFO = 1;
  static final int SCHED_RR = 2;

  /** Gives the threads and processes that the thread starts an ordinary scheduling class. */
  static final int SCHED_RESET_ON_FORK = 0x40000000;

  static final int MCL_CURRENT = 1;
  static final int MCL_FUTURE = 2;
  static final int PR_SET_TIMERSLACK = 29;
  static final int CLOCK_MONOTONIC = 1;
  static final int TIMER_ABSTIME = 1;

  static {
    Native.register(LinuxLibrary.class, "c");
  }

  private LinuxLibrary() {}

  /** Sets the scheduling of thread {@code tid} (0: the caller); {@code param} points to an int. */
  static native int sched_setscheduler(int tid, int policy, long param);

  static native int sched_setaffinity(int tid, long bytes, long mask);

  static native int mlockall(int flags);

  static native int prctl(int option, long a, long b, long c, long d);

  /** Returns 0 or the error number itself; a signal ends the sleep early. */
  static native int clock_nanosleep(int clock, int flags, long request, long remain);
}
