package org.palpate.realtime.os;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.BitSet;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LinuxSetupTest {
  private static final String ROOT_CAPABILITIES = "000001ffffffffff";
  private static final String NO_CAPABILITIES = "0000000000000000";

  @TempDir Path root;

  private final BitSet taken = new BitSet();

  @Test
  void grantsEverythingToRootOnFourProcessors() throws IOException {
    machine("0-3", ROOT_CAPABILITIES, "8388608");
    write("proc/self/task/12/comm", "VM Thread\n");
    write("proc/self/task/13/comm", "VM Periodic Tas\n");
    FakeScheduler scheduler = new FakeScheduler("");
    List<RequestOutcome> outcomes = setup(scheduler).apply(RealtimeRequest.recommended());
    assertEquals(List.of("lock", "slack 1", "cpus 3", "FIFO 40", "12 FIFO 39"), scheduler.calls);
    assertEquals(
        "memory_lock granted, timer_slack granted, affinity granted, class granted,"
            + " vm_threads granted",
        words(outcomes));
    assertEquals("{3}", taken.toString());
  }

  @Test
  void givesTwoThreadsTwoProcessorsAndKeepsOne() throws IOException {
    machine("0-2", ROOT_CAPABILITIES, "unlimited");
    FakeScheduler scheduler = new FakeScheduler("");
    setup(scheduler).apply(RealtimeRequest.recommended());
    setup(scheduler).apply(RealtimeRequest.recommended());
    RequestOutcome third = find(setup(scheduler).apply(RealtimeRequest.recommended()), "affinity");
    assertEquals("{1, 2}", taken.toString());
    assertFalse(third.granted());
    assertEquals("no processor would be left for everything else", third.detail());
  }

  @Test
  void deniesTheOnlyProcessorToAThreadThatNeverSleeps() throws IOException {
    machine("0", ROOT_CAPABILITIES, "unlimited");
    FakeScheduler scheduler = new FakeScheduler("");
    List<RequestOutcome> outcomes =
        setup(scheduler)
            .apply(new RealtimeRequest(SchedulingClass.FIFO, true, false, false, false));
    assertEquals("timer_slack granted, affinity refused, class refused", words(outcomes));
    assertEquals(List.of("slack 1"), scheduler.calls);
  }

  @Test
  void doesNotLockMemoryIfItsAmountIsLimited() throws IOException {
    machine("0-3", NO_CAPABILITIES, "8388608");
    FakeScheduler scheduler = new FakeScheduler("");
    RequestOutcome lock =
        find(setup(scheduler).apply(RealtimeRequest.recommended()), "memory_lock");
    assertFalse(lock.granted());
    assertTrue(lock.detail().contains("ulimit -l unlimited"), lock.detail());
    assertFalse(scheduler.calls.contains("lock"));
  }

  @Test
  void aDeniedClassNamesTheErrorAndTheRemedy() throws IOException {
    machine("0-3", NO_CAPABILITIES, "unlimited");
    RequestOutcome outcome =
        find(setup(new FakeScheduler("EPERM")).apply(RealtimeRequest.recommended()), "class");
    assertEquals("refused", outcome.word());
    assertTrue(outcome.detail().startsWith("EPERM; allow it with 'ulimit -r"), outcome.detail());
    assertTrue(taken.isEmpty(), "a denied processor is not taken");
  }

  @Test
  void staysBelowAVendorsThread() throws IOException {
    machine("0-3", ROOT_CAPABILITIES, "unlimited");
    thread(17, "HD (servo) loop", 20);
    thread(18, "main", 0);
    FakeScheduler scheduler = new FakeScheduler("");
    setup(scheduler).apply(RealtimeRequest.recommended());
    assertTrue(scheduler.calls.contains("FIFO 19"), scheduler.calls.toString());
  }

  @Test
  void staysAtTheDefaultPriorityBelowAHighVendorsThread() throws IOException {
    machine("0-3", ROOT_CAPABILITIES, "unlimited");
    thread(17, "servo", 99);
    FakeScheduler scheduler = new FakeScheduler("");
    setup(scheduler)
        .apply(new RealtimeRequest(SchedulingClass.ROUND_ROBIN, false, false, false, true));
    assertEquals(List.of("slack 1", "ROUND_ROBIN 40"), scheduler.calls);
  }

  @Test
  void raisesTheThreadsOfASafepointToOnePriorityBelow() throws IOException {
    machine("0-3", ROOT_CAPABILITIES, "unlimited");
    write("proc/self/task/12/comm", "VM Thread\n");
    write("proc/self/task/14/comm", "GC Thread#1\n");
    write("proc/self/task/15/comm", "G1 Conc#0\n");
    thread(17, "servo", 20);
    FakeScheduler scheduler = new FakeScheduler("");
    setup(scheduler).apply(RealtimeRequest.recommended());
    List<String> raised = scheduler.calls.stream().filter(a -> a.contains("FIFO 18")).toList();
    assertEquals(List.of("12 FIFO 18", "14 FIFO 18"), raised.stream().sorted().toList());
  }

  @Test
  void requestsOnlyTimerSlackForAnOrdinaryThread() throws IOException {
    machine("0-3", ROOT_CAPABILITIES, "unlimited");
    FakeScheduler scheduler = new FakeScheduler("");
    setup(scheduler).apply(RealtimeRequest.none());
    assertEquals(List.of("slack 1"), scheduler.calls);
  }

  private LinuxSetup setup(Scheduler scheduler) {
    return new LinuxSetup(scheduler, root, taken);
  }

  private void machine(String cpus, String capabilities, String lockedBytes) throws IOException {
    write("proc/self/status", "Cpus_allowed_list:\t" + cpus + "\nCapEff:\t" + capabilities + "\n");
    write(
        "proc/self/limits",
        "Max locked memory         " + lockedBytes + "   " + lockedBytes + "   bytes\n");
    Files.createDirectories(root.resolve("proc/self/task"));
  }

  /** Writes the stat file of a thread; the priority is field 40 in {@code man 5 proc}. */
  private void thread(int tid, String name, int priority) throws IOException {
    String between = "0 ".repeat(36);
    write(
        "proc/self/task/" + tid + "/stat", tid + " (" + name + ") S " + between + priority + " 1");
  }

  private void write(String path, String text) throws IOException {
    Path file = root.resolve(path);
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }

  private static RequestOutcome find(List<RequestOutcome> outcomes, String request) {
    return outcomes.stream()
        .filter(outcome -> outcome.request().equals(request))
        .findFirst()
        .orElseThrow();
  }

  private static String words(List<RequestOutcome> outcomes) {
    return outcomes.stream()
        .map(outcome -> outcome.request() + " " + outcome.word())
        .collect(Collectors.joining(", "));
  }
}
