package org.palpate.realtime;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.Deque;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.realtime.os.Throttling;

/** A paced thread beside a model of the kernel, on a clock of their own. */
class RestBudgetTest {
  private static final Throttling USUAL = new Throttling(950_000, 1_000_000);
  private static final long SECOND = 1_000_000_000;
  private static final long SPIN_STEP = 200;

  /** The part of a sleep that the kernel counts as running: falling asleep and waking up, ns. */
  private static final long SWITCHES = 5_000;

  /** The lateness of the end of a sleep, ns. */
  private static final long WAKE_UP = 30_000;

  private long now = 5 * SECOND;
  private long slept;
  private long lateFrames;
  private long mostLate;

  /** The sleeps of the last second, as pairs of their end and their length. */
  private final Deque<long[]> sleeps = new ArrayDeque<>();

  private long sleptInSecond;
  private long leastSleptInSecond = Long.MAX_VALUE;

  /** The same without the time of falling asleep and waking up. */
  private long leastCountedInSecond = Long.MAX_VALUE;

  private void sleepUntil(long due) {
    long end = Math.max(now, due) + WAKE_UP;
    slept += end - now;
    sleptInSecond += end - now;
    sleeps.add(new long[] {end, end - now});
    now = end;
  }

  private void forgetOldSleeps() {
    while (!sleeps.isEmpty() && sleeps.peek()[0] < now - SECOND) {
      sleptInSecond -= sleeps.remove()[1];
    }
  }

  /** Runs frames for some seconds, as {@code PacedLoop} does. */
  private void run(Throttling throttling, long periodNanos, long windowNanos, long workNanos) {
    HybridWait wait =
        new HybridWait(this::sleepUntil, windowNanos, throttling, () -> now += SPIN_STEP);
    long start = now;
    long deadline = now;
    while (now < start + 4 * SECOND) {
      wait.awaitUntil(deadline);
      long late = now - deadline;
      lateFrames += late > periodNanos / 2 ? 1 : 0;
      mostLate = Math.max(mostLate, late);
      now += workNanos;
      forgetOldSleeps();
      if (now > start + 2 * SECOND) {
        leastSleptInSecond = Math.min(leastSleptInSecond, sleptInSecond);
        long counted = sleptInSecond - SWITCHES * sleeps.size();
        leastCountedInSecond = Math.min(leastCountedInSecond, counted);
      }
      long missed = late > periodNanos / 2 ? (late + periodNanos / 2) / periodNanos : 0;
      deadline += (missed + 1) * periodNanos;
    }
  }

  @ParameterizedTest
  @CsvSource({
    "1000000, 60000, 20000",
    "200000, 60000, 20000",
    "200000, 200000, 20000",
    "100000, 60000, 10000",
    "100000, 60000, 30000",
    "100000, 60000, 50000",
    "100000, 95000, 10000",
    "100000, 400000, 10000",
    "100000, 400000, 90000",
    "100000, 400000, 99000",
    "100000, 400000, 300000",
    "20000, 400000, 5000"
  })
  void everySecondHasTheRestThatTheKernelAsksFor(long period, long window, long work) {
    run(USUAL, period, window, work);
    assertTrue(leastSleptInSecond >= 50_000_000, "slept ns in a second: " + leastSleptInSecond);
  }

  @Test
  void framesAtTenKilohertzRestWithoutBeingLate() {
    run(USUAL, 100_000, 400_000, 10_000);
    assertEquals(0, lateFrames, "a debt waits for a frame that has room");
    assertTrue(mostLate < 50_000, "ns: " + mostLate);
  }

  @ParameterizedTest
  @CsvSource({"100000, 400000, 10000", "100000, 400000, 40000", "200000, 400000, 10000"})
  void aThreadThatSpinsBetweenAllFramesSleepsSixPercentByTheKernelsCount(
      long period, long window, long work) {
    run(USUAL, period, window, work);
    assertTrue(leastCountedInSecond >= 60_000_000, "slept ns in a second: " + leastCountedInSecond);
  }

  @Test
  void aThreadThatSleepsAnywayOwesNothing() {
    HybridWait wait = new HybridWait(this::sleepUntil, 60_000, USUAL, () -> now += SPIN_STEP);
    for (int frame = 0; frame < 1000; frame++) {
      long deadline = now + 1_000_000;
      wait.awaitUntil(deadline);
      assertTrue(now >= deadline && now <= deadline + SPIN_STEP, "ns: " + (now - deadline));
    }
  }

  @Test
  void aKernelWithoutALimitAsksForNoRest() {
    run(Throttling.read(java.nio.file.Path.of("/nowhere")), 100_000, 400_000, 10_000);
    assertEquals(0, slept);
  }

  @Test
  void theRestAfterALongComputationIsThatOfOneKernelPeriod() {
    RestBudget rest = new RestBudget(USUAL);
    assertEquals(now, rest.wakeNanos(now, now));
    long later = now + 100 * SECOND;
    long restNanos = rest.wakeNanos(later, later) - later;
    assertTrue(Math.abs(restNanos - 65_000_000) <= 1, "ns: " + restNanos);
  }
}
