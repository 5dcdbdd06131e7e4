package org.palpate.realtime.os;

import com.sun.jna.Native;
import com.sun.jna.WString;

/**
 * Binds Windows calls directly, one class for each DLL, so that a missing DLL disables only its own
 * calls.
 *
 * <p>Source: avrt.h, timeapi.h, synchapi.h, winbase.h of the Windows SDK.
 */
final class WindowsLibrary {
  static final int CREATE_WAITABLE_TIMER_HIGH_RESOLUTION = 2;
  static final int TIMER_ALL_ACCESS = 0x1F0003;
  static final int INFINITE = -1;

  private WindowsLibrary() {}

  /** The multimedia class scheduler. */
  static final class Avrt {
    static {
      Native.register(Avrt.class, "avrt");
    }

    private Avrt() {}

    /** Returns a handle, 0 on failure; {@code taskIndex} is the address of an int. */
    static native long AvSetMmThreadCharacteristicsW(WString task, long taskIndex);

    /** Sets a priority from -2 to 2. */
    static native boolean AvSetMmThreadPriority(long handle, int priority);
  }

  /** The resolution of the system's timer. */
  static final class Winmm {
    static {
      Native.register(Winmm.class, "winmm");
    }

    private Winmm() {}

    /** Returns 0 on success. */
    static native int timeBeginPeriod(int milliseconds);
  }

  /** Timers, affinity and memory. */
  static final class Kernel32 {
    static {
      Native.register(Kernel32.class, "kernel32");
    }

    private Kernel32() {}

    static native long CreateWaitableTimerExW(long attributes, WString name, int flags, int access);

    /** Starts a timer; {@code dueTime} points to a long, negative if relative, in 100 ns units. */
    static native boolean SetWaitableTimer(
        long timer, long dueTime, int period, long routine, long argument, boolean resume);

    static native int WaitForSingleObject(long handle, int milliseconds);

    static native boolean CloseHandle(long handle);

    static native long GetCurrentThread();

    static native long GetCurrentProcess();

    /** Returns the previous mask, 0 on failure. */
    static native long SetThreadAffinityMask(long thread, long mask);

    /** Writes two longs to the given addresses. */
    static native boolean GetProcessAffinityMask(long process, long mask, long systemMask);
  }
}
