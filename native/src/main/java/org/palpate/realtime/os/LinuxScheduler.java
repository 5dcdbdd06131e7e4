package org.palpate.realtime.os;

import com.sun.jna.Memory;
import com.sun.jna.Native;
import com.sun.jna.Pointer;
import java.util.BitSet;

/** Sends the requests to Linux through its C library. */
final class LinuxScheduler implements Scheduler {
  private static final int MASK_BYTES = 128; // 1024 processors, the C library's cpu_set_t

  @Override
  public String setRealtime(int tid, SchedulingClass schedulingClass, int priority) {
    int policy =
        schedulingClass == SchedulingClass.ROUND_ROBIN
            ? LinuxLibrary.SCHED_RR
            : LinuxLibrary.SCHED_FIFO;
    try (Memory param = new Memory(Integer.BYTES)) {
      param.setInt(0, priority);
      return answer(
          LinuxLibrary.sched_setscheduler(
              tid, policy | LinuxLibrary.SCHED_RESET_ON_FORK, Pointer.nativeValue(param)));
    }
  }

  @Override
  public String setAffinity(BitSet cpus) {
    try (Memory mask = new Memory(MASK_BYTES)) {
      mask.clear();
      byte[] bytes = cpus.toByteArray();
      mask.write(0, bytes, 0, Math.min(bytes.length, MASK_BYTES));
      return answer(LinuxLibrary.sched_setaffinity(0, MASK_BYTES, Pointer.nativeValue(mask)));
    }
  }

  @Override
  public String lockMemory() {
    return answer(LinuxLibrary.mlockall(LinuxLibrary.MCL_CURRENT | LinuxLibrary.MCL_FUTURE));
  }

  @Override
  public String setTimerSlack(long nanos) {
    return answer(LinuxLibrary.prctl(LinuxLibrary.PR_SET_TIMERSLACK, nanos, 0, 0, 0));
  }

  private static String answer(int result) {
    return result == 0 ? "" : errorName(Native.getLastError());
  }

  private static String errorName(int error) {
    return switch (error) {
      case 1 -> "EPERM";
      case 11 -> "EAGAIN";
      case 12 -> "ENOMEM";
      case 22 -> "EINVAL";
      default -> "errno " + error;
    };
  }
}
