package org.palpate.realtime.os;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;

/**
 * Asks Linux for what a haptic thread wishes and writes down every answer. Called by the thread it
 * is for.
 */
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
   * @param root {@code /}, or a tree that looks like it
   * @param takenCpus processors given away by this process, added to when one more is
   */
  LinuxSetup(Scheduler scheduler, Path root, BitSet takenCpus) {
    this.scheduler = scheduler;
    this.root = root;
    this.takenCpus = takenCpus;
  }

  /** Memory first, since locking it takes long; the real-time class last, when all is in place. */
  List<RequestOutcome> apply(RealtimeRequest wish) {
    List<RequestOutcome> grants = new ArrayList<>();
    if (wish.lockMemory()) {
      grants.add(lockMemory());
    }
    grants.add(setTimerSlack());
    CpuTopology topology = CpuTopology.read(root);
    int priority = RealtimePriority.belowLowestThread(root.resolve("proc/self/task"));
    if (wish.pin()) {
      grants.add(pin(topology));
    }
    if (wish.schedulingClass() != SchedulingClass.NORMAL) {
      grants.add(setRealtime(wish, topology, priority));
    }
    if (wish.raiseVm() && wish.schedulingClass() != SchedulingClass.NORMAL) {
      grants.add(raiseVm(Math.max(1, priority - 1)));
    }
    return grants;
  }

  private RequestOutcome lockMemory() {
    // Locked now and limited later, the JVM could not get memory any more and would end.
    if (memoryIsLimited()) {
      return RequestOutcome.refused("memory_lock", ASK_FOR_MEMORY);
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
      return RequestOutcome.refused("affinity", "no processor would be left for everything else");
    }
    BitSet only = new BitSet();
    only.set(cpu.getAsInt());
    RequestOutcome grant =
        answer("affinity", scheduler.setAffinity(only), "cpu " + topology.name(cpu.getAsInt()), "");
    if (grant.granted()) {
      takenCpus.or(only);
    }
    return grant;
  }

  private RequestOutcome setRealtime(RealtimeRequest wish, CpuTopology topology, int priority) {
    if (!wish.sleepsEachFrame() && topology.allowed().cardinality() < 2) {
      return RequestOutcome.refused(
          "class", "a thread that never sleeps would keep the only processor");
    }
    String name = wish.schedulingClass().name().toLowerCase(Locale.ROOT);
    return answer(
        "class",
        scheduler.setRealtime(0, wish.schedulingClass(), priority),
        name + " " + priority,
        ASK_FOR_PRIORITY);
  }

  private RequestOutcome raiseVm(int priority) {
    List<Integer> threads = VmThreads.in(root.resolve("proc/self/task"));
    String error = threads.isEmpty() ? "no thread of a known name" : "";
    for (int tid : threads) {
      String answer = scheduler.setRealtime(tid, SchedulingClass.FIFO, priority);
      error = error.isEmpty() ? answer : error;
    }
    return answer("vm_threads", error, "fifo " + priority, ASK_FOR_PRIORITY);
  }

  private static RequestOutcome answer(String wish, String error, String what, String advice) {
    if (error.isEmpty()) {
      return RequestOutcome.granted(wish, what);
    }
    return RequestOutcome.refused(wish, advice.isEmpty() ? error : error + "; " + advice);
  }
}
