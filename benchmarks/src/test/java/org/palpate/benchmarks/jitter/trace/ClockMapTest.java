package org.palpate.benchmarks.jitter.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.benchmarks.jitter.trace.ClockMap.Pair;

class ClockMapTest {
  private static final long EPOCH = 1_700_000_000_000_000_000L;
  private static final long SECOND = 1_000_000_000L;

  @Test
  void followsAClockThatDriftsByTwentyPartsInAMillion() {
    ClockMap map =
        ClockMap.through(
            List.of(
                pair(EPOCH, 500, 10), pair(EPOCH + 100 * SECOND, 100 * SECOND + 2_000_500, 10)));
    assertEquals(500, map.toNanoTime(EPOCH));
    assertEquals(50 * SECOND + 1_000_500, map.toNanoTime(EPOCH + 50 * SECOND));
  }

  @Test
  void usesTheNarrowestPairOfEachHalf() {
    List<Pair> pairs = new ArrayList<>();
    pairs.add(pair(EPOCH, 80_000, 160_000)); // preempted between its two readings
    pairs.add(pair(EPOCH + 1_000, 1_000, 40));
    pairs.add(pair(EPOCH + 10 * SECOND, 10 * SECOND, 40));
    pairs.add(pair(EPOCH + 11 * SECOND, 11 * SECOND + 900_000, 1_800_000));
    ClockMap map = ClockMap.through(pairs);
    assertEquals(5 * SECOND, map.toNanoTime(EPOCH + 5 * SECOND));
  }

  @Test
  void assumesTheSameRateForASinglePair() {
    ClockMap map = ClockMap.through(List.of(pair(EPOCH, 42, 0)));
    assertEquals(42 + SECOND, map.toNanoTime(EPOCH + SECOND));
  }

  @Test
  void refusesToGuessWithoutAPair() {
    assertThrows(IllegalArgumentException.class, () -> ClockMap.through(List.of()));
  }

  private static Pair pair(long recording, long middle, long width) {
    return new Pair(recording, middle - width / 2, middle + width / 2);
  }
}
