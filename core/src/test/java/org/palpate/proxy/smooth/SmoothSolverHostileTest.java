package org.palpate.proxy.smooth;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.testing.HostileTouch;

/** What holds for the guarded solver under hostile numbers holds for the smooth one. */
class SmoothSolverHostileTest {

  @Test
  void keepsTheGuaranteeInHostileScenes() {
    long legs =
        new HostileTouch(SmoothSolver::new)
            .keepsTheGuarantee(300, (metric, device, before, after) -> true);
    assertTrue(legs > 20_000, "too few legs to mean anything: " + legs);
  }

  @Test
  void comesToRestWhenTheDeviceRests() {
    new HostileTouch(SmoothSolver::new).comesToRest(200, 200, solver -> {});
  }
}
