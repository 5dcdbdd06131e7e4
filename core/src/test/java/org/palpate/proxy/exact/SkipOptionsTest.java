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
import org.palpate.proxy.SkipCounters;
import org.palpate.proxy.SkipKind;
import org.palpate.proxy.reference.CollisionOnlySolver;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.Phantom;

class SkipOptionsTest {
  private static final long SEED = Seeds.seed();
  private static final GridMetric METRIC = new GridMetric(1, 1, 1);
  private static final double MAX_STEP_MM = 8;
  private static final int FRAMES = 20_000;
  private static final int EDGE = 48;
  private static final SkipOptions NOTHING = new SkipOptions(false, false, false, false);

  private final BitCube bits = Phantom.parse("sphere:" + EDGE).segments().segments().get(0).bits();

  /** Where a hand leads the point that wanders on and in a ball, rests, and jumps. */
  private double[] wayOf(ProxySolver solver) {
    SplittableRandom random = new SplittableRandom(SEED);
    CollisionScene obstacles = new CollisionScene(List.of(bits));
    InteractionPoint point = new InteractionPoint();
    Vec3 device = new Vec3(1.5, 1.5, 1.5);
    point.position.set(device);
    double[] way = new double[3 * FRAMES];
    for (int frame = 0; frame < FRAMES; frame++) {
      if (random.nextInt(4) != 0) {
        wander(device, random);
      }
      solver.follow(obstacles, device, point);
      for (int axis = 0; axis < 3; axis++) {
        way[3 * frame + axis] = point.position.get(axis);
      }
    }
    return way;
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

  private static SkipCounters countsOf(ProxySolver solver) {
    SkipCounters counts = new SkipCounters();
    solver.addSkips(counts);
    return counts;
  }

  @Test
  void whatIsSkippedLeadsThePointNowhereElse() {
    double[] expected = wayOf(new GuardedSolver(METRIC, MAX_STEP_MM));
    for (int off = 0; off < 3; off++) {
      SkipOptions skips = new SkipOptions(off != 0, off != 1, true, off != 2);
      double[] way = wayOf(new GuardedSolver(METRIC, MAX_STEP_MM, skips));
      for (int n = 0; n < way.length; n++) {
        assertEquals(expected[n], way[n], skips + " seed=" + SEED + " frame=" + n / 3);
      }
    }
  }

  @Test
  void aPointAtRestHasSkippedNoClimbThatLeadsNearer() {
    SplittableRandom random = new SplittableRandom(SEED);
    CollisionScene obstacles = new CollisionScene(List.of(bits));
    GuardedSolver solver = new GuardedSolver(METRIC, MAX_STEP_MM);
    InteractionPoint point = new InteractionPoint();
    InteractionPoint other = new InteractionPoint();
    Vec3 device = new Vec3(1.5, 1.5, 1.5);
    point.position.set(device);
    for (int rest = 0; rest < 3 * FRAMES; rest++) {
      for (int frame = 0; frame < 3; frame++) {
        wander(device, random);
        solver.follow(obstacles, device, point);
      }
      do {
        solver.follow(obstacles, device, point);
      } while (point.legs.count() > 0);
      solver.follow(obstacles, device, point);
      other.position.set(point.position);
      new GuardedSolver(METRIC, MAX_STEP_MM, NOTHING).follow(obstacles, device, other);
      assertEquals(0, other.legs.count(), "seed=" + SEED + " rest=" + rest + " " + point.position);
    }
  }

  @Test
  void countsWhatItSkipsAndNothingWhereItDoesNot() {
    GuardedSolver skips = new GuardedSolver(METRIC, MAX_STEP_MM);
    wayOf(skips);
    GuardedSolver skipsNothing = new GuardedSolver(METRIC, MAX_STEP_MM, NOTHING);
    wayOf(skipsNothing);
    for (SkipKind kind :
        List.of(SkipKind.EMPTY_BRICKS, SkipKind.NEIGHBOURS, SkipKind.CLIMBS, SkipKind.REST)) {
      assertTrue(countsOf(skips).of(kind) > 0, kind + " seed=" + SEED);
      assertEquals(0, countsOf(skipsNothing).of(kind), kind.key());
    }
  }

  @Test
  void countsEveryFrameWithoutResponse() {
    CollisionOnlySolver solver = new CollisionOnlySolver(new ExactRayCaster(), METRIC);
    wayOf(solver);
    assertEquals(FRAMES, countsOf(solver).byKey().get("response"));
  }
}
