package org.palpate.benchmarks.stress;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.volume.BitCube;

/** Breaks each promise of a solver in turn; one solid voxel lies at (2,2,2). */
class FrameJudgeTest {
  private static final double MAX_STEP_MM = 4;
  private static final Vec3 START = new Vec3(0.5, 0.5, 0.5);
  private static final String GAP = "leg 0 does not start where the last one ended";
  private static final String NOT_NEARER = "the frame ended neither nearer nor at the same bits";

  private final InteractionPoint point = new InteractionPoint();

  FrameJudgeTest() {
    point.position.set(START);
  }

  private static FrameJudge judge(SolverFactory factory, double maxStepMm) {
    BitCube bits = new BitCube(5, 5, 5);
    bits.set(2, 2, 2);
    return new FrameJudge(
        new HostileScene("planted", bits, new Vec3(1, 1, 2), maxStepMm), START, factory);
  }

  private static FrameJudge judge() {
    return judge(GuardedSolver::new, MAX_STEP_MM);
  }

  /** Takes one leg to a position. */
  private void move(double x, double y, double z, double lengthMm) {
    point.legs.clear();
    add(x, y, z, lengthMm);
  }

  private void add(double x, double y, double z, double lengthMm) {
    Vec3 p = point.position;
    point.legs.add(p.x, p.y, p.z, x, y, z, lengthMm, false);
    p.set(x, y, z);
  }

  private String fault(FrameJudge judge, double x, double y, double z) {
    return judge.fault(new Vec3(x, y, z), point, 0);
  }

  @Test
  void acceptsLegsThatConnectAndEndNearer() {
    FrameJudge judge = judge();
    move(1.5, 0.5, 0.5, 1);
    add(1.5, 1.5, 0.5, 1);
    assertNull(fault(judge, 3, 3, 0.5));
    move(1.5, 1.75, 0.5, 0.25);
    assertNull(fault(judge, 3, 3, 0.5));
    assertEquals(3, judge.legs());
  }

  @Test
  void findsALegThatTouchesASolidByItsCornerAlone() {
    move(2, 2, 2, 3);
    assertEquals("leg 0 touches a solid", fault(judge(), 2, 2, 2));
  }

  @Test
  void namesTheLegThatTouches() {
    FrameJudge judge = judge();
    move(0.5, 2.5, 0.5, 2);
    add(0.5, 2.5, 2.5, 2);
    add(1, 2.5, 2.5, 0.5);
    add(3.5, 2.5, 2.5, 2.5);
    assertEquals("leg 3 touches a solid", fault(judge, 4, 2.5, 2.5));
  }

  @Test
  void findsAGapOfOneUlpAndAZeroOfTheOtherSign() {
    FrameJudge judge = judge();
    point.position.x = Math.nextUp(START.x);
    move(1, 0.5, 0.5, 0.5);
    assertEquals(GAP, fault(judge, 2, 0.5, 0.5));
    judge = judge();
    point.position.set(START);
    move(0.0, 0.5, 0.5, 0.5);
    assertNull(fault(judge, -1, 0.5, 0.5));
    point.position.x = -0.0;
    move(-0.5, 0.5, 0.5, 0.5);
    assertEquals(GAP, fault(judge, -1, 0.5, 0.5));
  }

  @Test
  void findsAGapBetweenTwoLegsOfAFrame() {
    FrameJudge judge = judge();
    move(1, 0.5, 0.5, 0.5);
    point.position.z = Math.nextUp(0.5);
    add(1.5, 0.5, 0.5, 0.5);
    assertEquals("leg 1 does not start where the last one ended", fault(judge, 3, 0.5, 0.5));
  }

  @Test
  void findsAPointThatMovedWithoutALeg() {
    point.position.y = Math.nextUp(START.y);
    assertEquals("the point is not where its last leg ended", fault(judge(), 3, 0.5, 0.5));
  }

  @Test
  void acceptsAPathOfExactlyTheLongestStepAndFindsALongerOne() {
    move(4.5, 0.5, 0.5, MAX_STEP_MM);
    assertNull(fault(judge(), 9, 0.5, 0.5));
    point.position.set(START);
    move(4.5, 0.5, 0.5, MAX_STEP_MM * (1 + 1e-11));
    assertTrue(fault(judge(), 9, 0.5, 0.5).startsWith("the path is longer than w_max: 4.0000"));
  }

  @Test
  void findsAFrameThatMovesButEndsAsFarAwayAsBefore() {
    move(0.5, 1.5, 0.5, 1);
    assertEquals(NOT_NEARER, fault(judge(), 3, 1, 0.5));
    point.position.set(START);
    move(0.5, 1.5, 0.5, 1);
    assertNull(judge(SolverFactory.SMOOTH, MAX_STEP_MM).fault(new Vec3(3, 1, 0.5), point, 0));
  }

  @Test
  void measuresNearnessInMillimetresAndNotInVoxels() {
    move(2.4, 0.5, 1.6, 3); // (2.6, 0, 2.2) mm away, before that (4.5, 0, 0) mm
    assertNull(fault(judge(), 5, 0.5, 0.5));
    point.position.set(START);
    move(0.5 + 1e-3, 0.5, 1.5, 2); // a voxel along z is 2 mm
    assertEquals(NOT_NEARER, fault(judge(), 1.6, 0.5, 0.5));
  }

  @Test
  void findsAPointThatDoesNotRestAlthoughTheDeviceDoes() {
    FrameJudge judge = judge();
    int accepted = framesAccepted(judge, 0, 50);
    assertEquals(1 + 2, accepted, "a frame for the path, and two to settle");
  }

  @Test
  void aFrameThatUsedUpItsWorkBudgetMayBeFollowedByTwoMore() {
    assertEquals(50, framesAccepted(judge(), GuardedSolver.STEP_BUDGET + 1, 50));
    assertEquals(3, framesAccepted(judge(), GuardedSolver.STEP_BUDGET, 50));
  }

  @Test
  void restingIsCountedAnewWhenTheDeviceMoves() {
    FrameJudge judge = judge();
    for (int n = 1; n <= 50; n++) {
      creep(n);
      assertNull(judge.fault(new Vec3(n % 2 == 0 ? 3 : 4, 0.5, 0.5), point, 0), "frame " + n);
    }
  }

  @Test
  void aStepThatDoublesCanHardlyResolveIsNotJudgedByItsFrames() {
    assertEquals(50, framesAccepted(judge(GuardedSolver::new, 4e-10), 0, 50));
    assertEquals(3, framesAccepted(judge(GuardedSolver::new, 1e-9), 0, 50));
  }

  /** Creeps towards a resting device by a millionth of a voxel and less in each frame. */
  private int framesAccepted(FrameJudge judge, int steps, int most) {
    point.position.set(START);
    for (int n = 1; n <= most; n++) {
      creep(n);
      String fault = judge.fault(new Vec3(3, 0.5, 0.5), point, steps);
      if (fault != null) {
        assertTrue(fault.startsWith("with a resting device it took " + n + " frames"), fault);
        return n - 1;
      }
    }
    return most;
  }

  private void creep(int n) {
    double next = START.x + n * 1e-12;
    move(next, 0.5, 0.5, 1e-12);
  }

  @Test
  void remembersWhereAFaultyFrameEnded() {
    FrameJudge judge = judge();
    move(0.5, 0.5, 1.5, 2);
    assertNotNull(fault(judge, 3, 0.5, 0.5));
    move(0.75, 0.5, 1.5, 0.25);
    assertNull(fault(judge, 3, 0.5, 0.5));
  }

  /** A coordinate of 2^23 has steps of 2^-29, so with an edge of 8 mm w_max must exceed 2^-6 mm. */
  @Test
  void theLongestEdgeOfAVoxelDecidesWhetherDoublesResolveAStep() {
    int settle = SolverFactory.SMOOTH.framesToSettle();
    int most = settle + 40;
    for (int coordinate = 0; coordinate < 3; coordinate++) {
      for (int longest = 0; longest < 3; longest++) {
        Vec3 start = new Vec3().set(START);
        start.set(coordinate, 0x1p23);
        Vec3 spacingMm = new Vec3(1, 1, 1);
        spacingMm.set(longest, 8);
        String what = "coordinate " + coordinate + ", longest edge " + longest;
        assertEquals(most, framesAccepted(start, spacingMm, 0x1p-6, most), what);
        assertEquals(settle, framesAccepted(start, spacingMm, 0x1.1p-6, most), what);
      }
    }
  }

  /** Alternates between two positions one step of doubles apart, beside a resting device. */
  private int framesAccepted(Vec3 start, Vec3 spacingMm, double maxStepMm, int most) {
    HostileScene empty = new HostileScene("empty", new BitCube(5, 5, 5), spacingMm, maxStepMm);
    FrameJudge judge = new FrameJudge(empty, start, SolverFactory.SMOOTH);
    point.position.set(start);
    int axis = start.y == START.y ? 1 : 2;
    Vec3 to = new Vec3().set(start);
    for (int n = 1; n <= most; n++) {
      to.set(axis, n % 2 == 0 ? START.x : Math.nextUp(START.x));
      move(to.x, to.y, to.z, 0);
      if (judge.fault(start, point, 0) != null) {
        return n - 1;
      }
    }
    return most;
  }

  @Test
  void aDeviceFarAwayIsNotJudgedByTheNumberOfFrames() {
    FrameJudge judge = judge(SolverFactory.SMOOTH, 1e-3);
    int settle = SolverFactory.SMOOTH.framesToSettle();
    for (int n = 1; n <= settle + 20; n++) {
      creep(n);
      assertNull(judge.fault(new Vec3(1e9, 0.5, 0.5), point, 0), "frame " + n);
    }
  }

  @Test
  void aPathOfManyLongestStepsMayTakeTwiceAsManyFrames() {
    FrameJudge judge = judge();
    point.position.set(START);
    int accepted = 0;
    for (int n = 1; n <= 60; n++) {
      double to = n <= 5 ? START.x + 4 * n : START.x + 20 + n * 1e-9;
      move(to, 0.5, 0.5, n <= 5 ? 4 : 1e-9);
      if (judge.fault(new Vec3(900, 0.5, 0.5), point, 0) != null) {
        break;
      }
      accepted = n;
    }
    assertEquals(11 + 2, accepted, "10 for 20 mm, one for the rest of it, and two to settle");
  }

  @Test
  void anExactDecisionIsCounted() {
    FrameJudge judge = judge();
    move(1.5, 0.5, 0.5, 1);
    fault(judge, 3, 3, 0.5);
    assertEquals(0, judge.exactDecisions());
    point.position.set(START);
    judge = judge();
    move(1, 3, 2.5, 3);
    add(3, 1, 2.5, 1);
    assertEquals("leg 1 touches a solid", fault(judge, 3, 1, 2.5));
    assertTrue(judge.exactDecisions() > 0, "the leg passes through an edge of the voxel");
  }
}
