package org.palpate.proxy.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;
import org.palpate.testing.LegJudge;
import org.palpate.volume.BitCube;

/** A start one subnormal number before a face: seed 7, case 1666 of the stress test. */
class SubnormalStartTest {
  private final Vec3 start = new Vec3(-Double.MIN_VALUE, 11, 0);
  private final Vec3 device = new Vec3(2, 7.198376558202945, 2 * Double.MIN_VALUE);

  @Test
  void namesTheAxisOfAFaceWhoseCrossingRoundsToZero() {
    RayHit hit = new RayHit();
    Ray ray = new Ray().from(start.x, start.y, start.z).to(device.x, device.y, device.z);
    assertTrue(new ExactRayCaster().cast(comb(), ray, hit));
    assertEquals(0, hit.axis);
  }

  @Test
  void aFrameFromThereEndsAndKeepsTheGuarantee() {
    InteractionPoint point = new InteractionPoint();
    point.position.set(start);
    ProxySolver solver = new GuardedSolver(new GridMetric(1, 1, 1), 1e9);
    BitCube comb = comb();
    CollisionScene scene = new CollisionScene(List.of(comb));
    LegJudge judge = new LegJudge(comb, start);
    assertTimeoutPreemptively(Duration.ofSeconds(20), () -> solver.follow(scene, device, point));
    assertNull(judge.faultOf(point));
  }

  private static BitCube comb() {
    BitCube bits = new BitCube(1, 14, 2);
    for (int j = 0; j < 14; j++) {
      bits.set(0, j, 0);
    }
    return bits;
  }
}
