package org.palpate.realtime.os;

import com.sun.jna.Native;

/**
 * The C library's calls, mapped directly. Addresses are {@code long}, so that a call in a frame
 * makes no object; 64-bit systems only.
 *
 * <p>Source: sched.h, sys/mman.h, sys/prctl.h, time.h, fcntl.h, sys/resource.h of Linux.
 */
final class LinuxLibrary {
  static final int SCHED_FIFO = 1;
  static final int SCHED_RR = 2;

  /** A thread or process that ours starts is an ordinary one. */
  static final int SCHED_RESET_ON_FORK = 0x40000000;

  static final int MCL_CURRENT = 1;
  static final int MCL_FUTURE = 2;
  static final int PR_SET_TIMERSLACK = 29;
  static final int CLOCK_MONOTONIC = 1;
  static final int TIMER_ABSTIME = 1;
  static final int RUSAGE_THREAD = 1;
  static final int O_RDONLY = 0;
  static final int O_CLOEXEC = 0x80000;

  static {
    Native.register(LinuxLibrary.class, "c");
  }

  private LinuxLibrary() {}

  /** Sets scheduling of thread {@code tid}, 0 for the caller; {@code param} is one int. */
  static native int sched_setscheduler(int tid, int policy, long param);

  static native int sched_setaffinity(int tid, long bytes, long mask);

  static native int mlockall(int flags);

  static native int prctl(int option, long a, long b, long c, long d);

  /** Returns 0 or the error itself; a signal ends it early. */
  static native int clock_nanosleep(int clock, int flags, long request, long remain);

  static native int open(String path, int flags);

  static native long pread(int descriptor, long buffer, long bytes, long offset);

  static native int close(int descriptor);

  /** Fills a {@code struct rusage}. */
  static native int getrusage(int who, long usage);
}
