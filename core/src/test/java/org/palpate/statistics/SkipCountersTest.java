package org.palpate.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class SkipCountersTest {
  private final SkipCounters counters = new SkipCounters();
  private final SkipCounters others = new SkipCounters();

  @Test
  void eachKindIsCountedForItself() {
    counters.add(SkipKind.REST, 3);
    counters.add(SkipKind.REST, 4);
    counters.add(SkipKind.CLIMBS, 10);
    counters.add(SkipKind.CLIMBS, -1);
    assertEquals(7, counters.of(SkipKind.REST));
    assertEquals(9, counters.of(SkipKind.CLIMBS));
    assertEquals(0, counters.of(SkipKind.FRICTION));
  }

  @Test
  void allCountsOfOtherCountersAreAddedAndSubtracted() {
    counters.add(SkipKind.REST, 3);
    others.add(SkipKind.REST, 10);
    others.add(SkipKind.RESPONSE, 20);
    counters.add(others);
    assertEquals(13, counters.of(SkipKind.REST));
    assertEquals(20, counters.of(SkipKind.RESPONSE));
    counters.subtract(others);
    counters.subtract(others);
    assertEquals(-7, counters.of(SkipKind.REST));
    assertEquals(-20, counters.of(SkipKind.RESPONSE));
    assertEquals(10, others.of(SkipKind.REST), "the others stay");
  }

  @Test
  void theReportHasEveryKindInOrder() {
    counters.add(SkipKind.BESIDE_BOUNDS, 5);
    assertEquals(
        List.of(
            "empty_bricks",
            "beside_bounds",
            "far_objects",
            "neighbours",
            "climbs",
            "rest",
            "response",
            "friction"),
        new ArrayList<>(counters.byKey().keySet()));
    assertEquals(5, counters.byKey().get("beside_bounds"));
    assertEquals(0, counters.byKey().get("friction"));
  }
}
