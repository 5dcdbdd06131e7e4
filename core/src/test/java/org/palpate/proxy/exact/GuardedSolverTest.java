package org.palpate.proxy.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.testing.HostileTouch;
import org.palpate.testing.LegJudge;
import org.palpate.testing.RandomCases;
import org.palpate.volume.BitCube;

class GuardedSolverTest {
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);

  private final InteractionPoint point = new InteractionPoint();

  @Test
  void movesToAFreeDeviceBitForBit() {
    Vec3 device = new Vec3(3.1, 0.7, 5.3);
    follow(new BitCube(8, 8, 8), new Vec3(1.5, 1.5, 1.5), device, 100);
    assertTrue(point.position.sameBits(device));
    assertFalse(point.contact);
    assertEquals(1, point.legs.count());
  }

  @Test
  void stopsJustBeforeAWallAndSlidesAlongIt() {
    BitCube bits = new BitCube(8, 8, 8);
    for (int j = 0; j < 8; j++) {
      for (int k = 0; k < 8; k++) {
        bits.set(4, j, k);
      }
    }
    follow(bits, new Vec3(1.5, 1.5, 1.5), new Vec3(6.5, 5.5, 2.5), 100);
    assertTrue(point.position.sameBits(new Vec3(4 - GuardedSolver.STOP_SHORT_VOXELS, 5.5, 2.5)));
    assertTrue(point.contact);
  }

  @Test
  void doesNotSlipBetweenTwoSolidsThatShareOnlyAnEdge() {
    BitCube bits = new BitCube(2, 2, 1);
    bits.set(1, 0, 0);
    bits.set(0, 1, 0);
    follow(bits, new Vec3(0.5, 0.5, 0.5), new Vec3(1.5, 1.5, 0.5), 1);
    assertTrue(point.position.x < 1 && point.position.y < 1);
  }

  /** From 1e17 all ray parameters round to 1, so that the order of the solids is unclear. */
  @Test
  void stopsBeforeTheFirstOfTwoSolidsFromFarOut() {
    BitCube bits = new BitCube(16, 16, 16);
    bits.set(3, 5, 5);
    bits.set(6, 5, 5);
    follow(bits, new Vec3(1e17, 5.5, 5.5), new Vec3(1.5, 5.5, 5.5), 1e19);
    BitCube one = new BitCube(16, 16, 16);
    one.set(3, 5, 5);
    BitCube other = new BitCube(16, 16, 16);
    other.set(6, 5, 5);
    Vec3 start = new Vec3(1e17, 5.5, 5.5);
    point.position.set(start);
    LegJudge judge = new LegJudge(other, start);
    CollisionScene both = new CollisionScene(List.of(one, other));
    new GuardedSolver(UNIT, 1e19).follow(both, new Vec3(1.5, 5.5, 5.5), point);
    assertNull(judge.faultOf(point));
  }

  @Test
  void aProxyInASolidStaysUntilItIsSetFree() {
    BitCube bits = new BitCube(4, 4, 4);
    bits.setBrick(0, 0, 0, -1L);
    point.position.set(1.5, 1.5, 1.5);
    CollisionScene scene = new CollisionScene(List.of(bits));
    new GuardedSolver(UNIT, 100).follow(scene, new Vec3(3.5, 1.7, 1.6), point);
    assertEquals(0, point.legs.count());
  }

  @Test
  void stepsUpOneVoxelIfTheTopIsNearer() {
    BitCube bits = floorWithStep();
    follow(bits, new Vec3(2.5, 1.5, 1.5), new Vec3(9.5, 1.5, 0.5), 100);
    assertEquals(9.5, point.position.x);
    assertEquals(2 + GuardedSolver.STOP_SHORT_VOXELS, point.position.z);
  }

  @Test
  void takesNoStepUpThatIsLongerThanTheRemainingPath() {
    follow(floorWithStep(), new Vec3(4.9, 1.5, 1.5), new Vec3(9.5, 1.5, 0.5), 0.9);
    assertTrue(point.position.z < 2, "z=" + point.position.z);
  }

  /**
   * The proxy is stuck beyond 2^31 voxels. The segment to the wall passes the edge of the floor at
   * less than a rounding, so that the leg cut before the wall touches it, and no double aside is
   * nearer. The step up along x that is tried then must not lead through the solids.
   */
  @Test
  void stepsUpNowhereFromBeyondTheNumbersOfVoxels() {
    BitCube bits = new BitCube(20, 10, 3);
    for (int i = 10; i < 20; i++) {
      bits.set(i, 4, 1);
    }
    for (int j = 4; j < 10; j++) {
      bits.set(2, j, 1);
    }
    Vec3 start = new Vec3(6081414654.0, 7.483519806356817, 1.5);
    follow(bits, start, new Vec3(1.5, 4.999999996528782, 1.5), 1e300);
  }

  private static BitCube floorWithStep() {
    BitCube bits = new BitCube(12, 3, 4);
    for (int i = 0; i < 12; i++) {
      for (int j = 0; j < 3; j++) {
        bits.set(i, j, 0);
        if (i >= 5) {
          bits.set(i, j, 1);
        }
      }
    }
    return bits;
  }

  private void follow(BitCube bits, Vec3 start, Vec3 device, double maxStepMm) {
    GuardedSolver solver = new GuardedSolver(UNIT, maxStepMm);
    CollisionScene scene = new CollisionScene(List.of(bits));
    point.position.set(start);
    LegJudge judge = new LegJudge(bits, start);
    solver.follow(scene, device, point);
    assertNull(judge.faultOf(point));
  }

  @Test
  void keepsTheGuaranteeAndComesNearerOrStaysInHostileScenes() {
    long legs =
        new HostileTouch(GuardedSolver::new)
            .keepsTheGuarantee(
                400,
                (metric, device, before, after) ->
                    after.sameBits(before)
                        || square(metric, after, device) < square(metric, before, device));
    assertTrue(legs > RandomCases.of(50_000), "too few legs to mean anything: " + legs);
  }

  private static double square(GridMetric metric, Vec3 a, Vec3 b) {
    return metric.squaredDistance(a.x, a.y, a.z, b.x, b.y, b.z);
  }

  @Test
  void comesToRestWhenTheDeviceRests() {
    new HostileTouch(GuardedSolver::new).comesToRest(200, 40, ProxySolver::reset);
  }

  @Test
  void restsOnlyWhereAFreshSolverWouldRest() {
    new HostileTouch(GuardedSolver::new).restsWhereAFreshSolverWouldRest(200);
  }
}
