package org.palpate.benchmarks.moving;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class MovingBodiesStudyTest {
  @Test
  void theAttackOnMovingBodiesFindsNothing() {
    MovingBodiesStudy.Result result = new MovingBodiesStudy(20_000, 20, 3, line -> {}).run();
    assertEquals(0, result.touching(), result.toString());
    assertEquals(0, result.broken(), result.toString());
    assertEquals(0, result.overlapping(), result.toString());
    assertTrue(result.pushes() > 100 && result.heldBack() > 500, result.toString());
    assertTrue(result.holds() > 2_000, result.toString());
    assertTrue(result.contacts() > 1_000 && result.motions() > 5_000, result.toString());
  }
}
