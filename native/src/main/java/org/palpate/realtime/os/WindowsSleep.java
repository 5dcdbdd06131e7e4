package org.palpate.realtime.os;

import com.sun.jna.Memory;
import com.sun.jna.Pointer;

/** Sleeps on a waitable timer of high resolution, which Windows 10 1803 and later have. */
final class WindowsSleep implements PreciseSleep {
  private static final int NANOS_PER_TICK = 100;

  private final Memory due = new Memory(Long.BYTES);
  private final long dueAddress = Pointer.nativeValue(due);
  private long timer;

  /**
   * Creates the timer.
   *
   * @throws UnsupportedOperationException if Windows has no such timer
   */
  WindowsSleep() {
    timer =
        WindowsLibrary.Kernel32.CreateWaitableTimerExW(
            0,
            null,
            WindowsLibrary.CREATE_WAITABLE_TIMER_HIGH_RESOLUTION,
            WindowsLibrary.TIMER_ALL_ACCESS);
    if (timer == 0) {
      due.close();
      throw new UnsupportedOperationException("no waitable timer of high resolution");
    }
  }

  @Override
  public void until(long nanoTime) {
    long ticks = (nanoTime - System.nanoTime()) / NANOS_PER_TICK;
    if (ticks <= 0) {
      return;
    }
    due.setLong(0, -ticks);
    if (WindowsLibrary.Kernel32.SetWaitableTimer(timer, dueAddress, 0, 0, 0, false)) {
      WindowsLibrary.Kernel32.WaitForSingleObject(timer, WindowsLibrary.INFINITE);
    }
  }

  @Override
  public void close() {
    if (timer != 0) {
      WindowsLibrary.Kernel32.CloseHandle(timer);
      timer = 0;
      due.close();
    }
  }
}
