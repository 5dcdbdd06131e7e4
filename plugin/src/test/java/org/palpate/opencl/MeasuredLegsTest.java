package org.palpate.opencl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.collision.LegBatch;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;

/** The legs by which a device is measured and attacked. */
class MeasuredLegsTest {
  private static final long SEED = Seeds.seed();

  @Test
  void aBatchPaysFromTheLegsThatTakeAsLongOnTheCpu() {
    LaunchCost cost = new LaunchCost(2_000_000_000);
    double nanos = cost.nanosPerLeg();
    assertTrue(nanos >= 1 && nanos < 1e6, nanos + " ns for a leg");
    assertEquals(100, cost.crossover(99.5 * nanos, 1000));
    assertEquals(1000, cost.crossover(999.5 * nanos, 1000));
    assertEquals(LegBatch.NEVER, cost.crossover(1000.5 * nanos, 1000));
  }

  @Test
  void aBatchThatTakesHalfTheDeadlineIsNeverUsed() {
    LaunchCost cost = new LaunchCost(1000);
    assertTrue(cost.crossover(500, 1_000_000) != LegBatch.NEVER);
    assertEquals(LegBatch.NEVER, cost.crossover(500.5, 1_000_000));
  }

  @Test
  void pointsNearABallStartAboveItAndSomeLegsTouchIt() {
    NearBall ball = new NearBall(500);
    Vec3 point = new Vec3();
    for (int n = 0; n < ball.count(); n++) {
      double height = point.set(ball.x(n), ball.y(n), ball.z(n)).length() - 50;
      assertTrue(height >= -1e-9 && height <= 3 + 1e-9, "height " + height);
      ball.from().transform(point, point);
      assertTrue(point.x > 0 && point.x < 128, "inside the grid: " + point);
    }
    assertTrue(ball.voxels().get(64, 64, 64) && !ball.voxels().get(64, 64, 115));
    Vec3 start = ball.from().transform(new Vec3(), new Vec3());
    Vec3 step = ball.to().transform(new Vec3(), new Vec3()).sub(start, new Vec3());
    assertEquals("(0.31, -0.23, 0.17)", rounded(step));
  }

  private static String rounded(Vec3 v) {
    return new Vec3(
            Math.rint(v.x * 1e6) / 1e6, Math.rint(v.y * 1e6) / 1e6, Math.rint(v.z * 1e6) / 1e6)
        .toString();
  }

  @Test
  void grazingLegsComeWithinRoundingOfGridPlanes() {
    int count = 4000;
    GrazingLegs legs = new GrazingLegs(new SplittableRandom(SEED), 32, count);
    int near = 0;
    Vec3 start = new Vec3();
    Vec3 end = new Vec3();
    for (int n = 0; n < count; n++) {
      int motion = n % GrazingLegs.MOTIONS;
      Vec3 point = new Vec3(legs.x(n), legs.y(n), legs.z(n));
      legs.from(motion).transform(point, start);
      legs.to(motion).transform(point, end);
      near += grazes(start, end) ? 1 : 0;
    }
    assertTrue(near > count / 3, near + " of " + count + " graze, seed=" + SEED);
  }

  /** Whether a leg meets grid planes of two axes at nearly the same place. */
  private static boolean grazes(Vec3 start, Vec3 end) {
    for (int axis = 0; axis < 3; axis++) {
      double moved = end.get(axis) - start.get(axis);
      for (double plane = Math.ceil(Math.min(start.get(axis), end.get(axis)));
          plane <= Math.max(start.get(axis), end.get(axis)) && moved != 0;
          plane++) {
        double part = (plane - start.get(axis)) / moved;
        for (int other = 0; other < 3; other++) {
          double at = start.get(other) + part * (end.get(other) - start.get(other));
          if (other != axis && Math.abs(at - Math.rint(at)) < 1e-9) {
            return true;
          }
        }
      }
    }
    return false;
  }
}
