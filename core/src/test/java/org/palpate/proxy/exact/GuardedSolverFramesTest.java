package org.palpate.proxy.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.statistics.SkipCounters;
import org.palpate.statistics.SkipKind;
import org.palpate.testing.LegJudge;
import org.palpate.volume.BitCube;

/** Single frames: where legs end, what they cost, and what a solver remembers. */
class GuardedSolverFramesTest {
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);
  private static final double GAP = GuardedSolver.STOP_SHORT_VOXELS;
  private static final int EDGE = 48;

  private final BitCube bits = new BitCube(EDGE, 8, EDGE);
  private final InteractionPoint point = new InteractionPoint();

  private static Vec3 turned(int axis, double along, double beside, double across) {
    Vec3 v = new Vec3();
    v.set(axis, along);
    v.set((axis + 1) % 3, beside);
    v.set((axis + 2) % 3, across);
    return v;
  }

  private GuardedSolver follow(BitCube solids, Vec3 start, Vec3 device, double maxStepMm) {
    GuardedSolver solver = new GuardedSolver(UNIT, maxStepMm);
    point.position.set(start);
    solver.follow(new CollisionScene(List.of(solids)), device, point);
    return solver;
  }

  @ParameterizedTest
  @CsvSource({"0, 3, 1", "0, 40, 6", "1, 40, 6", "2, 40, 6", "2, 60, 8", "0, 100, 9", "1, -40, 6"})
  void aLongSlideCountsAsOneMoreStepForEachEightVoxelsUpToSixtyFour(
      int axis, double voxels, int steps) {
    Vec3 start = turned(axis, 1.5, 2.5, 3.5);
    Vec3 device = turned(axis, 1.5 + voxels, 2.75, 4.5);
    assertEquals(steps, follow(new BitCube(8, 8, 8), start, device, 1_000).steps());
    assertTrue(point.position.sameBits(device));
  }

  /** A wall of one voxel lies across the axis at 20. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void theFirstLegEndsShortOfTheWallOnTheSegmentToTheDevice(int axis) {
    BitCube wall = new BitCube(32, 32, 32);
    for (int n = 0; n < 32 * 32; n++) {
      int across = n / 32;
      Vec3 cell = turned(axis, 20, n % 32, across);
      wall.set((int) cell.x, (int) cell.y, (int) cell.z);
    }
    Vec3 low = turned(axis, 10.5, 5.25, 6.125);
    Vec3 high = turned(axis, 25.5, 11.75, 9.5);
    follow(wall, low, high, 1_000);
    assertEnd(axis, 20 - GAP, 5.25 + (9.5 - GAP) / 15 * 6.5, 6.125 + (9.5 - GAP) / 15 * 3.375);
    assertTrue(point.contact);
    assertTrue(point.position.sameBits(turned(axis, 20 - GAP, 11.75, 9.5)));
    follow(wall, high, low, 1_000);
    assertEnd(axis, 21 + GAP, 11.75 - (4.5 - GAP) / 15 * 6.5, 9.5 - (4.5 - GAP) / 15 * 3.375);
    assertTrue(point.contact);
    follow(wall, low, turned(axis, 25.5, 5.25, 6.125), 1_000);
    assertEnd(axis, 20 - GAP, 5.25, 6.125);
    assertEquals(1, point.legs.count());
    GuardedSolver again = new GuardedSolver(UNIT, 1_000);
    again.follow(new CollisionScene(List.of(wall)), turned(axis, 22, 5.25, 6.125), point);
    assertEquals(0, point.legs.count(), "it stands before the wall already");
    assertTrue(point.contact);
  }

  private void assertEnd(int axis, double along, double beside, double across) {
    Vec3 expected = turned(axis, along, beside, across);
    assertFalse(point.legs.slid(0));
    for (int n = 0; n < 3; n++) {
      assertEquals(expected.get(n), point.legs.end(0, n), 1e-12, "coordinate " + n);
    }
    assertEquals(along, point.legs.end(0, axis));
  }

  @Test
  void aPointThatIsStillOnItsWayIsInContactIfASolidHidesTheDevice() {
    BitCube wall = new BitCube(32, 8, 8);
    for (int n = 0; n < 64; n++) {
      wall.set(20, n % 8, n / 8);
    }
    Vec3 start = new Vec3(2.5, 3.5, 3.5);
    follow(wall, start, new Vec3(25.5, 4.5, 3.5), 5);
    assertEquals(5, point.legs.lengthMm(), 1e-6);
    assertTrue(point.contact);
    follow(wall, start, new Vec3(19.5, 4.5, 3.5), 5);
    assertEquals(5, point.legs.lengthMm(), 1e-6);
    assertFalse(point.contact);
    follow(wall, start, new Vec3(4.5, 4.5, 3.5), 5);
    assertFalse(point.contact);
  }

  /** Makes the columns along z solid from 0 to the given height, from a number of x on. */
  private void raise(int fromX, int height) {
    for (int n = 0; n < EDGE * 8 * EDGE; n++) {
      int i = n % EDGE;
      int k = n / (EDGE * 8);
      if (i >= fromX && k < height) {
        bits.set(i, n / EDGE % 8, k);
      }
    }
  }

  /**
   * Steps of one voxel lead from x = 10 on to a plateau. The device is so deep that only the
   * plateau is nearer to it. From a distance of 8 voxels on, up to three steps up are tried in a
   * row.
   */
  @ParameterizedTest
  @CsvSource({
    "1, 14.5, 4, true",
    "2, 14.5, 4, false",
    "2, 30.5, 30, true",
    "3, 30.5, 30, true",
    "4, 30.5, 30, false"
  })
  void aPlateauIsClimbedByOneStepAndByThreeIfTheDeviceIsFar(
      int steps, double deviceX, double depth, boolean climbs) {
    raise(0, 1);
    for (int step = 0; step < steps; step++) {
      raise(10 + step, 2 + step);
    }
    follow(bits, new Vec3(9.5, 3.5, 1.5), new Vec3(deviceX, 3.5, 1 - depth), 1_000);
    assertEquals(climbs ? deviceX : 10 - GAP, point.position.x);
    assertEquals(climbs ? 1 + steps + GAP : 1 + GAP, point.position.z);
    assertTrue(point.contact);
  }

  @Test
  void aStaircaseIsClimbedInSeveralFramesOfBoundedWork() {
    for (int step = 0; step < 40; step++) {
      raise(step, step + 1);
    }
    CollisionScene scene = new CollisionScene(List.of(bits));
    GuardedSolver solver = new GuardedSolver(UNIT, 1_000);
    point.position.set(0.5, 3.5, 1.5);
    LegJudge judge = new LegJudge(bits, point.position);
    Vec3 device = new Vec3(30.5, 3.5, 0.5);
    double before = 0;
    int frames = 0;
    int most = 0;
    do {
      before = point.position.x;
      solver.follow(scene, device, point);
      assertNull(judge.faultOf(point));
      most = Math.max(most, solver.steps());
      frames++;
    } while (point.position.x > before);
    assertTrue(frames > 2, "frames " + frames);
    assertTrue(most > GuardedSolver.STEP_BUDGET && most < 60, "most steps " + most);
    assertTrue(point.position.x > 14, "" + point.position);
  }

  @Test
  void framesAtRestAreSkippedUntilTheDeviceMoves() {
    raise(10, EDGE);
    CollisionScene scene = new CollisionScene(List.of(bits));
    GuardedSolver solver = new GuardedSolver(UNIT, 8);
    point.position.set(8.5, 3.5, 3.5);
    Vec3 device = new Vec3(12.5, 3.5, 3.5);
    for (int n = 0; n < 10; n++) {
      solver.follow(scene, device, point);
      assertTrue(point.contact);
    }
    long rested = rest(solver);
    assertTrue(rested >= 6 && rested < 10, "rested " + rested);
    for (int n = 0; n < 10; n++) {
      device.y += 0.01;
      solver.follow(scene, device, point);
      assertEquals(device.y, point.position.y);
    }
    assertEquals(rested, rest(solver));
  }

  private static long rest(GuardedSolver solver) {
    SkipCounters counts = new SkipCounters();
    solver.addSkips(counts);
    return counts.of(SkipKind.REST);
  }

  /** The device moves in each frame, so that nothing but {@code reset} makes the solver look. */
  @Test
  void afterAResetVoxelsThatCameStopThePointAndThoseThatWentLetItGoOn() {
    raise(0, 1);
    CollisionScene scene = new CollisionScene(List.of(bits));
    GuardedSolver solver = new GuardedSolver(UNIT, 8);
    point.position.set(6.5, 3.5, 1.5);
    LegJudge judge = new LegJudge(bits, point.position);
    Vec3 device = new Vec3(6.5, 3.5, 0.5);
    for (int n = 0; n < 5; n++) {
      device.x += 0.01;
      solver.follow(scene, device, point);
      assertNull(judge.faultOf(point));
    }
    for (int j = 0; j < 8; j++) {
      bits.set(7, j, 1);
      bits.set(7, j, 2);
    }
    solver.reset();
    device.x = 9.5;
    solver.follow(scene, device, point);
    assertNull(judge.faultOf(point));
    assertEquals(7 - GAP, point.position.x);
    device.x = 9.51;
    solver.follow(scene, device, point);
    assertNull(judge.faultOf(point));
    for (int j = 0; j < 8; j++) {
      bits.clear(7, j, 2);
    }
    solver.reset();
    device.x = 9.52;
    solver.follow(scene, device, point);
    assertNull(judge.faultOf(point));
    assertEquals(9.52, point.position.x, "it climbs what is one voxel high now");
  }
}
