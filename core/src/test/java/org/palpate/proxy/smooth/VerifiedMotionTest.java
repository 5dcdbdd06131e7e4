package org.palpate.proxy.smooth;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;
import org.palpate.volume.BitCube;

/**
 * The point is at (1.5, 1.5, 1.5), and the voxel (4, 1, 1) is solid. Voxels are 1 x 1 x 2 mm, and
 * w_max is 4 mm.
 */
class VerifiedMotionTest {
  private static final Vec3 START = new Vec3(1.5, 1.5, 1.5);
  private static final Vec3 FREE = new Vec3(1.5, 3.5, 1.5);
  private static final Vec3 BEHIND_THE_SOLID = new Vec3(5.25, 1.5, 1.5);

  private final BitCube bits = new BitCube(8, 8, 8);
  private final CollisionScene scene = new CollisionScene(List.of(bits));
  private final VerifiedMotion motion = new VerifiedMotion(new GridMetric(1, 1, 2), 4);
  private final InteractionPoint point = new InteractionPoint();

  @BeforeEach
  void beginAFrame() {
    bits.set(4, 1, 1);
    point.position.set(START);
    motion.beginFrame(scene, point);
  }

  @Test
  void aProposalMovesNothingUntilItIsCommitted() {
    assertTrue(motion.verify(FREE));
    assertTrue(point.position.sameBits(START));
    assertFalse(motion.hasMoved());
    motion.commit(true);
    assertTrue(point.position.sameBits(FREE));
    assertTrue(motion.hasMoved());
  }

  @Test
  void aLegHasItsEndsItsLengthAndItsKind() {
    motion.slide(FREE);
    motion.move(new Vec3(1.5, 3.5, 2.25));
    LegPath legs = point.legs;
    assertEquals(2, legs.count());
    assertLeg(0, START, FREE, 2);
    assertLeg(1, FREE, new Vec3(1.5, 3.5, 2.25), 1.5);
    assertTrue(legs.slid(0));
    assertFalse(legs.slid(1));
  }

  private void assertLeg(int leg, Vec3 start, Vec3 end, double mm) {
    for (int axis = 0; axis < 3; axis++) {
      assertEquals(start.get(axis), point.legs.start(leg, axis));
      assertEquals(end.get(axis), point.legs.end(leg, axis));
    }
    assertEquals(mm, point.legs.lengthMm(leg));
  }

  @Test
  void aLegThatTouchesASolidIsRefusedAndSaysWhere() {
    assertFalse(motion.verify(BEHIND_THE_SOLID));
    assertEquals(2.5 / 3.75, motion.blockedFraction(), 1e-15);
    assertEquals(0, motion.blockedAxis());
    assertThrows(IllegalStateException.class, () -> motion.commit(false));
    assertFalse(motion.move(BEHIND_THE_SOLID));
    assertFalse(motion.slide(new Vec3(4, 1.5, 1.5)), "it ends on the face");
    assertTrue(point.position.sameBits(START));
    assertEquals(0, point.legs.count());
  }

  @Test
  void onlyTheLastProposalCounts() {
    assertTrue(motion.verify(FREE));
    assertFalse(motion.verify(BEHIND_THE_SOLID));
    assertThrows(IllegalStateException.class, () -> motion.commit(false));
    assertTrue(motion.verify(FREE));
    motion.commit(false);
    assertThrows(IllegalStateException.class, () -> motion.commit(false), "committed already");
  }

  @Test
  void aProposalDoesNotOutlastItsFrame() {
    assertTrue(motion.verify(FREE));
    motion.beginFrame(scene, point);
    assertThrows(IllegalStateException.class, () -> motion.commit(false));
    assertTrue(motion.verify(FREE));
    motion.takeBack();
    assertThrows(IllegalStateException.class, () -> motion.commit(false));
  }

  @Test
  void aLegWithoutLengthIsLeftOut() {
    assertTrue(motion.move(START));
    assertEquals(0, point.legs.count());
    assertFalse(motion.hasMoved());
  }

  @Test
  void aTargetThatIsNotFiniteIsRefused() {
    assertFalse(motion.verify(new Vec3(Double.NaN, 1.5, 1.5)));
    assertFalse(motion.verify(new Vec3(1.5, Double.POSITIVE_INFINITY, 1.5)));
  }

  @Test
  void aLegIsCutToThePathThatRemains() {
    assertTrue(motion.reaches(new Vec3(1.5, 5.5, 1.5)));
    assertFalse(motion.reaches(new Vec3(1.5, Math.nextUp(5.5), 1.5)));
    assertTrue(motion.move(new Vec3(1.5, 1.5, 7.5)));
    assertEquals(3.5, point.position.z, 1e-9, "4 mm are 2 voxels of 2 mm");
    assertTrue(point.legs.lengthMm() <= 4);
    assertFalse(motion.canMove());
    assertFalse(motion.reaches(0.1));
  }

  @Test
  void whatRemainsAfterALegLimitsTheNext() {
    assertTrue(motion.canMove());
    motion.move(FREE);
    assertTrue(motion.canMove());
    assertTrue(motion.reaches(2));
    assertFalse(motion.reaches(Math.nextUp(2.0)));
    Vec3 end = new Vec3();
    motion.cutToRemainingPath(new Vec3(1.5, 7.5, 1.5), end);
    assertEquals(5.5, end.y, 1e-9);
    assertTrue(point.position.sameBits(FREE));
  }

  @Test
  void aFullPathTakesNoFurtherLeg() {
    for (int n = 0; n < LegPath.CAPACITY; n++) {
      assertTrue(motion.canMove());
      assertTrue(motion.move(new Vec3(1.5, 1.5 + (n % 2 == 0 ? 0.01 : 0), 1.5)));
    }
    assertFalse(motion.canMove());
    assertFalse(motion.verify(FREE));
  }

  @Test
  void aFrameThatIsTakenBackEndsWhereItBegan() {
    motion.move(FREE);
    motion.move(new Vec3(1.5, 3.5, 2.25));
    motion.takeBack();
    assertTrue(point.position.sameBits(START));
    assertEquals(0, point.legs.count());
    assertEquals(0, point.legs.lengthMm());
    assertTrue(motion.move(FREE));
    assertLeg(0, START, FREE, 2);
  }

  @Test
  void everySegmentThatIsCastCountsInItsFrame() {
    motion.isFree(FREE);
    motion.isFree(FREE, START);
    motion.move(FREE);
    assertEquals(3, motion.casts());
    motion.move(FREE);
    assertEquals(3, motion.casts(), "a leg without length needs no cast");
    motion.beginFrame(scene, point);
    assertEquals(0, motion.casts());
    assertTrue(motion.position().sameBits(FREE));
    assertEquals(0, point.legs.count());
  }

  @Test
  void aPositionBetweenTwoOthersDividesTheirSegment() {
    Vec3 between = new Vec3();
    VerifiedMotion.between(new Vec3(1, 2, 3), new Vec3(5, 10, -5), 0.25, between);
    assertTrue(between.sameBits(new Vec3(2, 4, 1)));
  }
}
