package org.palpate.proxy.smooth;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.testing.Floor;
import org.palpate.volume.BitCube;

/** A point over the floor at z = 8, with voxels that stand out of it. */
class LiftedMotionTest {
  /** The distance that the point keeps from a face below it. */
  private static final double GAP = 1e-3;

  private static final Vec3 UP = new Vec3(0, 0, 1);

  private final BitCube bits = Floor.bits();
  private final GridMetric metric = new GridMetric(1, 1, 1);
  private final VerifiedMotion motion = new VerifiedMotion(metric, 20);
  private final LiftedMotion lifted = new LiftedMotion(motion, new EdgeUnits(metric));
  private final InteractionPoint point = new InteractionPoint();

  private boolean move(Vec3 from, Vec3 to, Vec3 normal) {
    point.position.set(from);
    motion.beginFrame(new CollisionScene(List.of(bits)), point);
    return lifted.moveTo(to, normal);
  }

  private void assertAt(double x, double y, double z) {
    assertEquals(x, point.position.x, 1e-9);
    assertEquals(y, point.position.y, 1e-9);
    assertEquals(z, point.position.z, 1e-9);
  }

  @Test
  void aFreeTargetIsReachedToTheBit() {
    Vec3 to = new Vec3(18.25, 15.5, 8.75);
    assertTrue(move(new Vec3(16.5, 16.5, 9), to, UP));
    assertTrue(point.position.sameBits(to));
    assertEquals(1, point.legs.count());
    assertTrue(point.legs.slid(0));
  }

  @Test
  void overATargetInAVoxelThePointStopsJustAboveItsFace() {
    assertTrue(move(new Vec3(16.5, 16.5, 8.75), new Vec3(18.25, 15.5, 7.9), UP));
    assertAt(18.25, 15.5, 8 + GAP);
    assertEquals(1, point.legs.count());
    assertTrue(move(new Vec3(16.5, 16.5, 8.75), new Vec3(18.25, 15.5, 7.5), UP));
    assertAt(18.25, 15.5, 8 + GAP);
  }

  @Test
  void overATargetDeeperThanTheHighestLiftThePointRisesFirst() {
    assertTrue(move(new Vec3(16.5, 16.5, 8.75), new Vec3(18.25, 15.5, 6.5), UP));
    assertAt(18.25, 15.5, 8 + GAP);
    assertEquals(2, point.legs.count());
    assertEquals(8.8, point.legs.end(0, 2), 1e-12);
  }

  /** A step of one voxel begins at x = 18. */
  private void addStep() {
    for (int j = 0; j < Floor.EDGE; j++) {
      for (int i = 18; i < Floor.EDGE; i++) {
        bits.set(i, j, Floor.TOP);
      }
    }
  }

  @Test
  void aPointBeforeAStepGoesOverItInOneLegIfThatIsFree() {
    addStep();
    assertTrue(move(new Vec3(17, 16.5, 9.2), new Vec3(18.5, 16.5, 8.9), UP));
    assertAt(18.5, 16.5, 9 + GAP);
    assertEquals(1, point.legs.count());
    assertTrue(move(new Vec3(17, 16.5, 8.5), new Vec3(18.5, 16.5, 8.9), UP));
    assertAt(18.5, 16.5, 8.9 + 0.56);
    assertEquals(1, point.legs.count(), "the step cuts the leg to its face");
  }

  @Test
  void aPointAtTheFootOfAStepRisesAndThenMovesOver() {
    addStep();
    assertTrue(move(new Vec3(17.95, 16.5, 8.25), new Vec3(18.75, 16.5, 8.9), UP));
    assertAt(18.75, 16.5, 9 + GAP);
    assertEquals(2, point.legs.count());
    assertEquals(17.95, point.legs.end(0, 0), 1e-12, "it rises");
    assertEquals(8.25 + 1, point.legs.end(0, 2), 1e-12, "by the lowest lift that clears the step");
  }

  /** The normal leads into the wall, so that the point rises along it. */
  @Test
  void aWallInTheWayOfTheRiseTurnsItAlongTheWall() {
    addStep();
    Vec3 normal = new Vec3(0.6, 0, 0.8);
    assertTrue(move(new Vec3(17.98, 16.5, 8.25), new Vec3(18.4, 16.5, 8.9), normal));
    assertEquals(2, point.legs.count());
    assertEquals(17.98, point.legs.end(0, 0), 1e-12);
    assertTrue(point.legs.end(0, 2) > 9);
    assertTrue(point.position.x > 18 && point.position.z > 9, "" + point.position);
  }

  @Test
  void aPointUnderACeilingStaysWhereItIs() {
    addStep();
    for (int j = 0; j < Floor.EDGE; j++) {
      for (int i = 0; i < Floor.EDGE; i++) {
        bits.set(i, j, Floor.TOP + 1);
      }
    }
    Vec3 from = new Vec3(17.95, 16.5, 8.5);
    assertFalse(move(from, new Vec3(18.75, 16.5, 8.9), UP));
    assertEquals(17.95, point.position.x);
    assertTrue(point.position.z < 9);
  }
}
