package org.palpate.realtime;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.LongUnaryOperator;
import org.junit.jupiter.api.Test;

class SpinWindowTest {
  private long now = 1_000_000;
  private long sleeps;

  @Test
  void coversTheUsualLatenessWithAQuarterToSpare() {
    long window = measure(nth -> 60_000);
    assertTrue(window >= 75_000 && window < 75_200, "windowNanos=" + window);
  }

  @Test
  void isNotMisledByOneLongDelay() {
    long window = measure(nth -> nth == 50 ? 9_000_000 : 40_000);
    assertTrue(window >= 50_000 && window < 50_200, "windowNanos=" + window);
  }

  @Test
  void staysWithinItsLimits() {
    assertEquals(SpinWindow.MIN_NANOS, measure(nth -> 0));
    assertEquals(SpinWindow.MAX_NANOS, measure(nth -> 5_000_000));
  }

  @Test
  void takesAnEarlyWakeUpAsPunctual() {
    assertEquals(SpinWindow.MIN_NANOS, measure(nth -> -30_000));
  }

  private long measure(LongUnaryOperator lateNanos) {
    sleeps = 0;
    return SpinWindow.measureNanos(
        due -> now = due + lateNanos.applyAsLong(sleeps++), 1_000_000, () -> now);
  }
}
