package org.palpate.realtime;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.realtime.os.Throttling;

class HybridWaitTest {
  private static final Throttling USUAL = new Throttling(950_000, 1_000_000);

  private final List<Long> sleptUntil = new ArrayList<>();
  private long now = 1_000_000;
  private long step = 100;
  private long lateNanos;

  @Test
  void sleepsToTheWindowThenSpinsToTheDeadline() {
    HybridWait wait = hybrid();
    wait.awaitUntil(2_000_000);
    assertEquals(List.of(1_900_000L), sleptUntil);
    assertEquals(2_000_000, now);
    assertEquals(step, wait.longestGapNanos());
  }

  @Test
  void doesNotSleepInsideTheWindow() {
    hybrid().awaitUntil(1_050_000);
    assertEquals(List.of(), sleptUntil);
    assertEquals(1_050_000, now);
  }

  @Test
  void returnsAtOnceIfTheDeadlineHasPassed() {
    long before = now;
    hybrid().awaitUntil(before - 1);
    assertEquals(before + step, now, "one clock reading");
  }

  @Test
  void doesNotSpinIfTheSleepWasTooLong() {
    lateNanos = 5_000_000;
    HybridWait wait = hybrid();
    wait.awaitUntil(2_000_000);
    assertEquals(0, wait.longestGapNanos());
  }

  @Test
  void returnsEarlyWhenInterruptedAndLeavesTheFlag() {
    Thread.currentThread().interrupt();
    hybrid().awaitUntil(2_000_000);
    assertTrue(Thread.interrupted());
    assertEquals(List.of(), sleptUntil);
    assertTrue(now < 2_000_000, "nanos=" + now);
  }

  @Test
  void countsAGapAsLongAsTheForcedRestAsThrottling() {
    HybridWait wait = hybrid();
    step = 39_000_000;
    wait.awaitUntil(now + 80_000);
    assertEquals(0, wait.throttled());
    step = 49_000_000;
    wait.awaitUntil(now + 49_000_000 + 20_000_000); // far enough for the rest that is due first
    assertEquals(1, wait.throttled());
    assertEquals(49_000_000, wait.longestGapNanos());
  }

  private HybridWait hybrid() {
    return new HybridWait(
        due -> {
          sleptUntil.add(due);
          now = due + lateNanos - step;
        },
        100_000,
        USUAL,
        () -> now += step);
  }
}
