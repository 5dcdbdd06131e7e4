package org.palpate.realtime.os;

import com.sun.jna.Memory;
import com.sun.jna.Pointer;
import com.sun.jna.WString;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;

/**
 * Sends the requests to Windows: the multimedia class scheduler, the timer's resolution and the
 * affinity. Memory is not locked, because Windows has no call that locks a whole process.
 */
final class WindowsSetup {
  private static final int HIGH = 1; // AVRT_PRIORITY_HIGH; vendors' threads may take CRITICAL, 2
  private static final String TASK = "Pro Audio";

  private final BitSet takenCpus;

  WindowsSetup(BitSet takenCpus) {
    this.takenCpus = takenCpus;
  }

  List<RequestOutcome> apply(RealtimeRequest request) {
    List<RequestOutcome> outcomes = new ArrayList<>();
    if (request.lockMemory()) {
      outcomes.add(RequestOutcome.denied("memory_lock", "Windows cannot lock a whole process"));
    }
    outcomes.add(setTimerResolution());
    if (request.pin()) {
      outcomes.add(pin());
    }
    if (request.schedulingClass() != SchedulingClass.NORMAL) {
      outcomes.add(joinMultimediaClass());
    }
    if (request.raiseVmThreads()) {
      outcomes.add(RequestOutcome.denied("vm_threads", "not supported on Windows"));
    }
    return outcomes;
  }

  private static RequestOutcome setTimerResolution() {
    int error = WindowsLibrary.Winmm.timeBeginPeriod(1);
    return error == 0
        ? RequestOutcome.granted("timer_slack", "1 ms")
        : RequestOutcome.denied("timer_slack", "error " + error);
  }

  private RequestOutcome pin() {
    BitSet allowed = allowedCpus();
    BitSet none = new BitSet();
    var cpu = new CpuTopology(allowed, none, none).choose(takenCpus);
    if (cpu.isEmpty()) {
      return RequestOutcome.denied("affinity", "no processor would be left for everything else");
    }
    long thread = WindowsLibrary.Kernel32.GetCurrentThread();
    if (WindowsLibrary.Kernel32.SetThreadAffinityMask(thread, 1L << cpu.getAsInt()) == 0) {
      return RequestOutcome.denied("affinity", "SetThreadAffinityMask failed");
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
        return RequestOutcome.denied(
            "class", "multimedia class scheduler: is its service running?");
      }
      boolean high = WindowsLibrary.Avrt.AvSetMmThreadPriority(handle, HIGH);
      return RequestOutcome.granted("class", high ? "mmcss high" : "mmcss");
    }
  }
}
