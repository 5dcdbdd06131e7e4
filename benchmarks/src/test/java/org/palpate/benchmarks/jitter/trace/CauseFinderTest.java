package org.palpate.benchmarks.jitter.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.palpate.benchmarks.jitter.trace.JvmEvent.Kind;

/** Finds the causes of delays that the test itself puts into the events. */
class CauseFinderTest {
  private static final long MILLI = 1_000_000;
  private static final long MICRO = 1_000;
  private static final int FRAMES = 1_000;
  private static final int LATE = 500;
  private static final long DUE = LATE * MILLI;
  private static final long USUAL_WORK = 50 * MICRO;
  private static final MachineActivity QUIET = new MachineActivity(List.of());

  private final List<JvmEvent> events = new ArrayList<>();

  @Test
  void aPauseThatCoversTheDelayIsTheCause() {
    event(Kind.GC_PAUSE, DUE - MILLI, DUE + 4 * MILLI, "G1CollectForAllocation");
    Cause cause = worst(late(4 * MILLI, 10 * MICRO, 0), QUIET, true);
    assertEquals(Cause.Kind.GC, cause.kind());
    assertEquals(LATE, cause.frame());
    assertEquals("4000 us paused for the collector (G1CollectForAllocation)", cause.evidence());
  }

  @Test
  void aPauseThatEndedBeforeTheDeadlineIsNotTheCause() {
    event(Kind.GC_PAUSE, DUE - 5 * MILLI, DUE - 1, "G1CollectForAllocation");
    Cause cause = worst(late(4 * MILLI, 10 * MICRO, 0), QUIET, true);
    assertEquals(Cause.Kind.OUTSIDE, cause.kind());
    assertEquals("nothing recorded", cause.evidence());
  }

  @Test
  void overlappingPausesAreNotCountedTwice() {
    event(Kind.GC_PAUSE, DUE, DUE + MILLI, "the whole");
    event(Kind.GC_PAUSE, DUE, DUE + MILLI, "its phase");
    event(Kind.GC_PAUSE, DUE + MILLI / 2, DUE + MILLI, "the phase's phase");
    Cause cause = worst(late(4 * MILLI, 0, 0), QUIET, true);
    assertEquals(Cause.Kind.OUTSIDE, cause.kind());
    assertTrue(cause.evidence().startsWith("1000 us paused"), cause.evidence());
  }

  @Test
  void aSafepointIsNamedByItsOperation() {
    event(Kind.SAFEPOINT, DUE, DUE + 3 * MILLI, "HeapDumper");
    Cause cause = worst(late(3 * MILLI, 0, 0), QUIET, true);
    assertEquals(Cause.Kind.SAFEPOINT, cause.kind());
    assertTrue(cause.evidence().contains("(HeapDumper)"), cause.evidence());
  }

  @Test
  void aStallOfAnotherThreadDoesNotCount() {
    event(Kind.ALLOCATION_STALL, DUE, DUE + 3 * MILLI, "stall");
    assertEquals(Cause.Kind.OUTSIDE, worst(late(3 * MILLI, 0, 0), QUIET, true).kind());
    events.clear();
    events.add(new JvmEvent(Kind.ALLOCATION_STALL, DUE, DUE + 3 * MILLI, "stall", true));
    assertEquals(Cause.Kind.GC, worst(late(3 * MILLI, 0, 0), QUIET, true).kind());
  }

  @Test
  void aThreadReadyButNotRunningIsDelayedByTheScheduler() {
    Cause cause = worst(late(3 * MILLI, 0, 2_900 * MICRO), QUIET, true);
    assertEquals(Cause.Kind.SCHEDULER, cause.kind());
    assertEquals("2900 us ready but not running", cause.evidence());
  }

  @Test
  void aCompilerMayHaveTheProcessorOfAnOrdinaryThread() {
    event(Kind.COMPILATION, DUE - MILLI, DUE + 3 * MILLI, "c2 Frame.run");
    assertEquals(Cause.Kind.JIT, worst(late(3 * MILLI, 0, 2_900 * MICRO), QUIET, false).kind());
  }

  @Test
  void aCompilerCannotHaveTheProcessorOfARealtimeThread() {
    event(Kind.COMPILATION, DUE - MILLI, DUE + 3 * MILLI, "c2 Frame.run");
    assertEquals(
        Cause.Kind.SCHEDULER, worst(late(3 * MILLI, 0, 2_900 * MICRO), QUIET, true).kind());
  }

  @Test
  void aDeoptimizationCausesTheLongWorkAfterIt() {
    events.add(new JvmEvent(Kind.DEOPTIMIZATION, DUE + 100, DUE + 100, "class_check", true));
    Cause cause = worst(late(10 * MICRO, 2 * MILLI, 0), QUIET, true);
    assertEquals(Cause.Kind.DEOPTIMIZATION, cause.kind());
  }

  @Test
  void aDeoptimizationInAnotherThreadIsNotTheCause() {
    event(Kind.DEOPTIMIZATION, DUE + 100, DUE + 100, "class_check");
    assertEquals(Cause.Kind.OUTSIDE, worst(late(10 * MICRO, 2 * MILLI, 0), QUIET, true).kind());
  }

  @Test
  void longWorkDuringItsCompilationIsCausedByTheJit() {
    event(Kind.COMPILATION, DUE, DUE + 2 * MILLI, "c1 Frame.run");
    assertEquals(Cause.Kind.JIT, worst(late(10 * MICRO, 2 * MILLI, 0), QUIET, true).kind());
  }

  @Test
  void workTooLongEvenForAnInterpreterIsNotCausedByTheJit() {
    event(Kind.COMPILATION, DUE, DUE + 9 * MILLI, "c2 Frame.run");
    assertEquals(Cause.Kind.OUTSIDE, worst(late(10 * MICRO, 9 * MILLI, 0), QUIET, true).kind());
  }

  @Test
  void timeStolenAboutThenIsCausedByTheHypervisor() {
    MachineActivity robbed =
        new MachineActivity(
            List.of(
                new MachineSample(DUE - 20 * MILLI, 0, 0, 0),
                new MachineSample(DUE - MILLI, 10 * MILLI, 0, 0),
                new MachineSample(DUE + 20 * MILLI, 20 * MILLI, 0, 0)));
    Cause cause = worst(late(8 * MILLI, 0, 0), robbed, true);
    assertEquals(Cause.Kind.STEAL, cause.kind());
    assertTrue(cause.evidence().startsWith("10000 us stolen"), cause.evidence());
  }

  @Test
  void theLargestOfSeveralSmallPartsNamesTheCause() {
    event(Kind.GC_PAUSE, DUE, DUE + MILLI, "ZMarkStart");
    event(Kind.SAFEPOINT, DUE + MILLI, DUE + 1_400 * MICRO, "Cleanup");
    Cause cause = worst(late(4 * MILLI, 0, 700 * MICRO), QUIET, true);
    assertEquals(Cause.Kind.GC, cause.kind());
  }

  @Test
  void findsTheWorstFramesInTheirOrder() {
    long seed = Long.getLong("palpate.seed", System.nanoTime());
    Random random = new Random(seed);
    List<Long> late = new ArrayList<>();
    Samples samples = new Samples(FRAMES);
    for (int i = 0; i < FRAMES; i++) {
      long nanos = random.nextInt(900_000);
      late.add(nanos);
      samples.add(i * MILLI, i * MILLI + nanos, i * MILLI + nanos, 0, 0, 0);
    }
    late.sort(Collections.reverseOrder());
    List<Long> found =
        new CauseFinder(List.of(), QUIET, USUAL_WORK, true)
            .worst(samples, 10).stream().map(Cause::latenessNanos).toList();
    assertEquals(late.subList(0, 10), found, "seed=" + seed);
  }

  private void event(Kind kind, long start, long end, String what) {
    events.add(new JvmEvent(kind, start, end, what, false));
  }

  /** Returns frames that are a microsecond late, except for one. */
  private static Samples late(long lateness, long work, long delayed) {
    Samples samples = new Samples(FRAMES);
    for (int i = 0; i < FRAMES; i++) {
      boolean isLate = i == LATE;
      long start = i * MILLI + (isLate ? lateness : MICRO);
      long counted = i < LATE ? 0 : delayed;
      samples.add(i * MILLI, start, start + (isLate ? work : MICRO), counted, 0, 0);
    }
    return samples;
  }

  private Cause worst(Samples samples, MachineActivity machine, boolean realtime) {
    return new CauseFinder(events, machine, USUAL_WORK, realtime).worst(samples, 1).get(0);
  }
}
