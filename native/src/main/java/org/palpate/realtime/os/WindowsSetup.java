package org.palpate.realtime.os;

import com.sun.jna.Memory;
import com.sun.jna.Pointer;
import com.sun.jna.WString;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;

/**
 * Asks Windows: the multimedia class scheduler, the timer's resolution, one processor. Its working
 * set is not locked, as Windows has no call that locks all of a process.
 */
final class WindowsSetup {
  private static final int HIGH = 1; // AVRT_PRIORITY_HIGH; vendors' threads may take CRITICAL, 2
  private static final String TASK = "Pro Audio";

  private final BitSet takenCpus;

  WindowsSetup(BitSet takenCpus) {
    this.takenCpus = takenCpus;
  }

  List<RequestOutcome> apply(RealtimeRequest wish) {
    List<RequestOutcome> grants = new ArrayList<>();
    if (wish.lockMemory()) {
      grants.add(RequestOutcome.refused("memory_lock", "Windows cannot lock a whole process"));
    }
    grants.add(setTimerResolution());
    if (wish.pin()) {
      grants.add(pin());
    }
    if (wish.schedulingClass() != SchedulingClass.NORMAL) {
      grants.add(joinMultimediaClass());
    }
    if (wish.raiseVm()) {
      grants.add(RequestOutcome.refused("vm_threads", "Windows: not known how"));
    }
    return grants;
  }

  private static RequestOutcome setTimerResolution() {
    int error = WindowsLibrary.Winmm.timeBeginPeriod(1);
    return error == 0
        ? RequestOutcome.granted("timer_slack", "1 ms")
        : RequestOutcome.refused("timer_slack", "error " + error);
  }

  private RequestOutcome pin() {
    BitSet allowed = allowedCpus();
    BitSet none = new BitSet();
    var cpu = new CpuTopology(allowed, none, none).choose(takenCpus);
    if (cpu.isEmpty()) {
      return RequestOutcome.refused("affinity", "no processor would be left for everything else");
    }
    long thread = WindowsLibrary.Kernel32.GetCurrentThread();
    if (WindowsLibrary.Kernel32.SetThreadAffinityMask(thread, 1L << cpu.getAsInt()) == 0) {
      return RequestOutcome.refused("affinity", "SetThreadAffinityMask failed");
    }
    takenCpus.set(cpu.getAsInt());
    return RequestOutcome.granted("affinity", "cpu " + cpu.getAsInt());
  }

  private static BitSet allowedCpus() {
    try (Memory masks = new Memory(2 * Long.BYTES)) {
      long address = Pointer.nativeValue(masks);
      long process = WindowsLibrary.Kernel32.GetCurrentProcess();
      boolean known =
          WindowsLibrary.Kernel32.GetProcessAffinityMask(process, address, address + Long.BYTES);
      return known ? BitSet.valueOf(new long[] {masks.getLong(0)}) : new BitSet();
    }
  }

  private static RequestOutcome joinMultimediaClass() {
    try (Memory taskIndex = new Memory(Integer.BYTES)) {
      taskIndex.clear();
      long handle =
          WindowsLibrary.Avrt.AvSetMmThreadCharacteristicsW(
              new WString(TASK), Pointer.nativeValue(taskIndex));
      if (handle == 0) {
        return RequestOutcome.refused(
            "class", "multimedia class scheduler: is its service running?");
      }
      boolean high = WindowsLibrary.Avrt.AvSetMmThreadPriority(handle, HIGH);
      return RequestOutcome.granted("class", high ? "mmcss high" : "mmcss");
    }
  }
}
