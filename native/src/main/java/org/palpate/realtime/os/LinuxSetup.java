package org.palpate.realtime.os;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;

/** Sends the requests of a haptic thread to Linux and records each outcome. For that thread. */
final class LinuxSetup {
  private static final long TIMER_SLACK_NANOS = 1;
  private static final int CAPABILITY_IPC_LOCK = 14;
  private static final String ASK_FOR_PRIORITY =
      "allow it with 'ulimit -r 40' or rtprio in /etc/security/limits.d";
  private static final String ASK_FOR_MEMORY =
      "allow it with 'ulimit -l unlimited' or memlock in /etc/security/limits.d";

  private final Scheduler scheduler;
  private final Path root;
  private final BitSet takenCpus;

  /**
   * Creates a set-up for one thread.
   *
   * @param root {@code /}, or a folder with the same structure
   * @param takenCpus processors that this process has given to threads; updated
   */
  LinuxSetup(Scheduler scheduler, Path root, BitSet takenCpus) {
    this.scheduler = scheduler;
    this.root = root;
    this.takenCpus = takenCpus;
  }

  /** Locks memory first, because that takes long; sets the real-time class last. */
  List<RequestOutcome> apply(RealtimeRequest request) {
    List<RequestOutcome> outcomes = new ArrayList<>();
    if (request.lockMemory()) {
      outcomes.add(lockMemory());
    }
    outcomes.add(setTimerSlack());
    CpuTopology topology = CpuTopology.read(root);
    int priority = RealtimePriority.belowLowestThread(root.resolve("proc/self/task"));
    if (request.pin()) {
      outcomes.add(pin(topology));
    }
    if (request.schedulingClass() != SchedulingClass.NORMAL) {
      outcomes.add(setRealtime(request, topology, priority));
    }
    if (request.raiseVmThreads() && request.schedulingClass() != SchedulingClass.NORMAL) {
      outcomes.add(raiseVmThreads(Math.max(1, priority - 1)));
    }
    return outcomes;
  }

  private RequestOutcome lockMemory() {
    // If memory is locked now but limited later, the JVM can get no more memory and ends.
    if (memoryIsLimited()) {
      return RequestOutcome.denied("memory_lock", ASK_FOR_MEMORY);
    }
    return answer("memory_lock", scheduler.lockMemory(), "now and later pages", ASK_FOR_MEMORY);
  }

  private boolean memoryIsLimited() {
    boolean mayLockAll =
        KernelFiles.field(root.resolve("proc/self/status"), "CapEff")
            .map(capabilities -> Long.parseUnsignedLong(capabilities, 16))
            .map(bits -> (bits >>> CAPABILITY_IPC_LOCK & 1) != 0)
            .orElse(false);
    boolean unlimited =
        KernelFiles.lines(root.resolve("proc/self/limits"))
            .anyMatch(line -> line.matches("Max locked memory\\s+unlimited\\s.*"));
    return !mayLockAll && !unlimited;
  }

  private RequestOutcome setTimerSlack() {
    return answer(
        "timer_slack", scheduler.setTimerSlack(TIMER_SLACK_NANOS), TIMER_SLACK_NANOS + " ns", "");
  }

  private RequestOutcome pin(CpuTopology topology) {
    OptionalInt cpu = topology.choose(takenCpus);
    if (cpu.isEmpty()) {
      return RequestOutcome.denied("affinity", "no processor would be left for everything else");
    }
    BitSet only = new BitSet();
    only.set(cpu.getAsInt());
    RequestOutcome outcome =
        answer("affinity", scheduler.setAffinity(only), "cpu " + topology.name(cpu.getAsInt()), "");
    if (outcome.granted()) {
      takenCpus.or(only);
    }
    return outcome;
  }

  private RequestOutcome setRealtime(RealtimeRequest request, CpuTopology topology, int priority) {
    if (!request.sleepsEachFrame() && topology.allowed().cardinality() < 2) {
      return RequestOutcome.denied(
          "class", "a thread that never sleeps would keep the only processor");
    }
    String name = request.schedulingClass().name().toLowerCase(Locale.ROOT);
    return answer(
        "class",
        scheduler.setRealtime(0, request.schedulingClass(), priority),
        name + " " + priority,
        ASK_FOR_PRIORITY);
  }

  private RequestOutcome raiseVmThreads(int priority) {
    List<Integer> threads = VmThreads.in(root.resolve("proc/self/task"));
    String error = threads.isEmpty() ? "no thread of a known name" : "";
    for (int tid : threads) {
      String answer = scheduler.setRealtime(tid, SchedulingClass.FIFO, priority);
      error = error.isEmpty() ? answer : error;
    }
    return answer("vm_threads", error, "fifo " + priority, ASK_FOR_PRIORITY);
  }

  private static RequestOutcome answer(String request, String error, String what, String advice) {
    if (error.isEmpty()) {
      return RequestOutcome.granted(request, what);
    }
    return RequestOutcome.denied(request, advice.isEmpty() ? error : error + "; " + advice);
  }
}
