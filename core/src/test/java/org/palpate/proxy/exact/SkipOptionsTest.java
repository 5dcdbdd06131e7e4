package org.palpate.proxy.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.reference.CollisionOnlySolver;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.statistics.SkipCounters;
import org.palpate.statistics.SkipKind;
import org.palpate.testing.RandomCases;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.Phantom;

class SkipOptionsTest {
  private static final long SEED = Seeds.seed();
  private static final GridMetric METRIC = new GridMetric(1, 1, 1);
  private static final double MAX_STEP_MM = 8;
  private static final int FRAMES = 20_000;
  private static final int EDGE = 48;
  private static final SkipOptions NOTHING = new SkipOptions(false, false, false);

  private final BitCube bits = Phantom.parse("sphere:" + EDGE).segments().segments().get(0).bits();

  /** Returns the positions of a proxy whose device wanders on and in a ball, rests, and jumps. */
  private double[] positionsOf(ProxySolver solver) {
    SplittableRandom random = new SplittableRandom(SEED);
    CollisionScene scene = new CollisionScene(List.of(bits));
    InteractionPoint point = new InteractionPoint();
    Vec3 device = new Vec3(1.5, 1.5, 1.5);
    point.position.set(device);
    double[] positions = new double[3 * FRAMES];
    for (int frame = 0; frame < FRAMES; frame++) {
      if (random.nextInt(4) != 0) {
        wander(device, random);
      }
      solver.follow(scene, device, point);
      for (int axis = 0; axis < 3; axis++) {
        positions[3 * frame + axis] = point.position.get(axis);
      }
    }
    return positions;
  }

  private static void wander(Vec3 device, SplittableRandom random) {
    double step = random.nextInt(50) == 0 ? 40 : 0.3;
    device.set(
        inside(device.x + step * (random.nextDouble() - 0.49)),
        inside(device.y + step * (random.nextDouble() - 0.49)),
        inside(device.z + step * (random.nextDouble() - 0.49)));
  }

  private static double inside(double coordinate) {
    return Math.max(0.3, Math.min(EDGE - 0.3, coordinate));
  }

  private static GuardedSolver solver(SkipOptions skips) {
    return GuardedSolver.skippingOnly(skips, METRIC, MAX_STEP_MM);
  }

  private static SkipCounters countsOf(ProxySolver solver) {
    SkipCounters counts = new SkipCounters();
    solver.addSkips(counts);
    return counts;
  }

  @Test
  void skippingNeighbourhoodsOrRestChangesNoPosition() {
    double[] expected = positionsOf(new GuardedSolver(METRIC, MAX_STEP_MM));
    for (SkipOptions skips :
        List.of(new SkipOptions(false, true, true), new SkipOptions(true, true, false))) {
      double[] positions = positionsOf(solver(skips));
      for (int n = 0; n < positions.length; n++) {
        assertEquals(expected[n], positions[n], skips + " seed=" + SEED + " frame=" + n / 3);
      }
    }
  }

  @Test
  void aProxyAtRestHasSkippedNoStepUpThatLeadsNearer() {
    SplittableRandom random = new SplittableRandom(SEED);
    CollisionScene scene = new CollisionScene(List.of(bits));
    GuardedSolver solver = new GuardedSolver(METRIC, MAX_STEP_MM);
    InteractionPoint point = new InteractionPoint();
    InteractionPoint other = new InteractionPoint();
    Vec3 device = new Vec3(1.5, 1.5, 1.5);
    point.position.set(device);
    for (int rest = 0; rest < RandomCases.of(3 * FRAMES); rest++) {
      for (int frame = 0; frame < 3; frame++) {
        wander(device, random);
        solver.follow(scene, device, point);
      }
      do {
        solver.follow(scene, device, point);
      } while (point.legs.count() > 0);
      solver.follow(scene, device, point);
      other.position.set(point.position);
      solver(NOTHING).follow(scene, device, other);
      assertEquals(0, other.legs.count(), "seed=" + SEED + " rest=" + rest + " " + point.position);
    }
  }

  @Test
  void countsEachSkipAndNoneThatIsSwitchedOff() {
    GuardedSolver skips = new GuardedSolver(METRIC, MAX_STEP_MM);
    positionsOf(skips);
    GuardedSolver skipsNothing = solver(NOTHING);
    positionsOf(skipsNothing);
    for (SkipKind kind : List.of(SkipKind.NEIGHBOURS, SkipKind.CLIMBS, SkipKind.REST)) {
      assertTrue(countsOf(skips).of(kind) > 0, kind + " seed=" + SEED);
      assertEquals(0, countsOf(skipsNothing).of(kind), kind.key());
    }
    assertTrue(countsOf(skips).of(SkipKind.EMPTY_BRICKS) > 0, "seed=" + SEED);
  }

  @Test
  void countsEveryFrameWithoutResponse() {
    CollisionOnlySolver solver = new CollisionOnlySolver(new ExactRayCaster(), METRIC);
    positionsOf(solver);
    assertEquals(FRAMES, countsOf(solver).byKey().get("response"));
  }
}
