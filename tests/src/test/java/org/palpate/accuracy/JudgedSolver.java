package org.palpate.accuracy;

import static org.junit.jupiter.api.Assertions.assertNull;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.testing.LegJudge;
import org.palpate.volume.BitCube;

/** A solver whose every leg is judged by the exact oracle. */
final class JudgedSolver implements ProxySolver {
  private final ProxySolver solver;
  private final BitCube bits;
  private LegJudge judge;

  JudgedSolver(ProxySolver solver, BitCube bits) {
    this.solver = solver;
    this.bits = bits;
  }

  @Override
  public void reset() {
    solver.reset();
    judge = null;
  }

  @Override
  public void follow(CollisionScene scene, Vec3 device, InteractionPoint point) {
    if (judge == null) {
      judge = new LegJudge(bits, point.position);
    }
    solver.follow(scene, device, point);
    assertNull(judge.faultOf(point));
  }
}
