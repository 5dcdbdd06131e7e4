package org.palpate.benchmarks.stability;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;

/** Work whose sum is known by a formula. */
class HandWorkTest {
  private static final int STEPS = 1_000;

  private final Vec3 none = new Vec3();

  /** A force of -x at each position: the potential of a spring of 1 N/mm. */
  private static Vec3 spring(Vec3 at) {
    return at.mul(-1, new Vec3());
  }

  /** Returns a position on a closed curve that begins and ends at the same place. */
  private static Vec3 onCurve(int frame) {
    double angle = 2 * Math.PI * frame / STEPS;
    return new Vec3(3 * Math.sin(angle), 2 - 2 * Math.cos(angle), Math.sin(2 * angle));
  }

  @Test
  void aConstantForceGivesItsProductWithTheWay() {
    HandWork work = new HandWork(0.5);
    Vec3 force = new Vec3(2, -1, 0);
    for (int frame = 0; frame <= STEPS; frame++) {
      double part = Math.max(0, Math.min(1, (frame - 5.0) / (STEPS - 10)));
      work.publish(new Vec3(10 + 6 * part, 7, 8), none, force, true, frame);
    }
    assertEquals(2 * 0.5 * 6, work.millijoule(), 1e-9, "2 N along 6 units of 0.5 mm");
  }

  @Test
  void aSpringGivesNothingOverAClosedMotionHoweverCoarseItsSteps() {
    for (int stride : new int[] {1, 20, 125}) {
      HandWork work = new HandWork(1);
      for (int frame = -2 * stride; frame <= STEPS + 2 * stride; frame += stride) {
        Vec3 at = onCurve(Math.max(0, Math.min(STEPS, frame)));
        work.publish(at, none, spring(at), true, frame / stride + 2);
      }
      assertEquals(0, work.millijoule(), 1e-9, "every " + stride + "th position");
    }
  }

  @Test
  void aForceThatLagsBehindASpringGivesAndOneAgainstTheMotionTakes() {
    HandWork lagging = new HandWork(1);
    HandWork braking = new HandWork(1);
    Vec3 last = onCurve(0);
    for (int frame = 0; frame <= STEPS; frame++) {
      Vec3 at = onCurve(frame);
      lagging.publish(at, none, spring(onCurve(Math.max(0, frame - 20))), true, frame);
      braking.publish(at, none, last.sub(at, new Vec3()), true, frame);
      last = at;
    }
    assertTrue(lagging.millijoule() > 0.1, "given: " + lagging.millijoule());
    assertTrue(braking.millijoule() < -0.01, "given: " + braking.millijoule());
  }

  @Test
  void aTorqueGivesItsProductWithTheAngle() {
    HandWork work = new HandWork(1);
    Vec3 torque = new Vec3(1, 0, 4);
    Pose pose = new Pose();
    for (int frame = 0; frame <= STEPS + 20; frame++) {
      double angle = 0.5 * Math.max(0, Math.min(STEPS, frame - 10)) / STEPS;
      pose.rotation.setRotationVector(new Vec3(0, 0, 0.3 + angle));
      work.publish(pose, null, none, torque, frame);
    }
    assertEquals(4 * 0.5, work.millijoule(), 1e-9, "4 N mm about z, half a radian");
  }
}
