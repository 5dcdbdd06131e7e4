package org.palpate.opencl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.collision.LegBatch;

class LaunchCostTest {
  @Test
  void aBatchPaysFromTheLegsThatTakeAsLongOnTheCpu() {
    LaunchCost cost = new LaunchCost(2_000_000_000);
    double nanos = cost.nanosPerLeg();
    assertTrue(nanos >= 1 && nanos < 1e6, nanos + " ns for a leg");
    assertEquals(100, cost.crossover(99.5 * nanos, 1000));
    assertEquals(1000, cost.crossover(999.5 * nanos, 1000));
    assertEquals(LegBatch.NEVER, cost.crossover(1000.5 * nanos, 1000));
  }

  @Test
  void aBatchThatTakesHalfTheDeadlineIsNeverUsed() {
    LaunchCost cost = new LaunchCost(1000);
    assertTrue(cost.crossover(500, 1_000_000) != LegBatch.NEVER);
    assertEquals(LegBatch.NEVER, cost.crossover(500.5, 1_000_000));
  }
}
