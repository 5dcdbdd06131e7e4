package org.palpate.proxy.smooth;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.testing.HostileTouch;
import org.palpate.testing.RandomCases;

/** Holds the smooth solver to the guarantee and the rest rule in hostile scenes. */
class SmoothSolverHostileTest {

  @Test
  void keepsTheGuaranteeInHostileScenes() {
    long legs =
        new HostileTouch(SmoothSolver::new)
            .keepsTheGuarantee(300, (metric, device, before, after) -> true);
    assertTrue(legs > RandomCases.of(20_000), "too few legs: " + legs);
  }

  @Test
  void comesToRestWhenTheDeviceRests() {
    new HostileTouch(SmoothSolver::new).comesToRest(200, 200, solver -> {});
  }
}
