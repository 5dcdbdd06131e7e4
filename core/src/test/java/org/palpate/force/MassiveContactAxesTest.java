package org.palpate.force;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.testing.Seeds;

/** A body with mass on floors across each axis: the axes are alike, and friction is Coulomb's. */
class MassiveContactAxesTest {
  private static final long MS = 1_000_000;
  private static final double[] SPACINGS = {1, 0.5, 2};
  private static final double STIFFNESS = 0.6;

  /** The motion of a slow slide in a frame of a millisecond. */
  private static final double SLOW_MM = 2e-4;

  /** Moves coordinate n of a vector to coordinate n + by. */
  private static Vec3 turned(Vec3 v, int by) {
    Vec3 turned = new Vec3();
    for (int axis = 0; axis < 3; axis++) {
      turned.set((axis + by) % 3, v.get(axis));
    }
    return turned;
  }

  private static MassiveContact body(
      int by, double sticking, double friction, double damping, Vec3 gravity) {
    Vec3 spacing = turned(new Vec3(SPACINGS[0], SPACINGS[1], SPACINGS[2]), by);
    Material material = new Material(STIFFNESS, sticking, friction, damping);
    ForceSettings settings = new ForceSettings(material, FrictionForm.CONE, false, List.of());
    return new MassiveContact(
        GridMetric.of(spacing), settings, new MassSettings(0.05, turned(gravity, by)));
  }

  /** Returns the forces of a hand that presses, slides and lifts at random, on a floor z = 0. */
  private static List<Vec3> session(int by) {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    MassiveContact body = body(by, 0.4, 0.3, 2e-4, new Vec3(300, -200, -9810));
    InteractionPoint point = new InteractionPoint();
    point.position.set(turned(new Vec3(3, 4, 1), by));
    body.place(point.position);
    Vec3 device = new Vec3(3, 4, 1);
    Vec3 speed = new Vec3();
    Vec3 target = new Vec3();
    Vec3 force = new Vec3();
    int floor = (2 + by) % 3;
    List<Vec3> forces = new ArrayList<>();
    for (int frame = 0; frame < 3_000; frame++) {
      if (frame % 100 == 0) {
        speed.set(
            random.nextDouble(-0.02, 0.02),
            random.nextDouble(-0.02, 0.02),
            random.nextDouble(-0.01, 0.01) - 5e-3 * (device.z + 0.6));
      }
      device.add(speed, device);
      body.move(point, turned(device, by), MS, target);
      point.contact = target.get(floor) < 0;
      point.position.set(target);
      point.position.set(floor, Math.max(0, target.get(floor)));
      body.compute(point, force);
      forces.add(new Vec3().set(force));
    }
    return forces;
  }

  @Test
  void theSameMotionAlongOtherAxesGivesTheSameForcesAlongThem() {
    List<Vec3> along = session(0);
    int touching = 0;
    for (int by = 1; by < 3; by++) {
      List<Vec3> others = session(by);
      for (int frame = 0; frame < along.size(); frame++) {
        Vec3 expected = turned(along.get(frame), by);
        double off = others.get(frame).sub(expected, expected).length();
        assertEquals(0, off, 1e-9, "seed " + Seeds.seed() + " frame " + frame + " by " + by);
        touching += along.get(frame).z > 0.6 ? 1 : 0;
      }
    }
    assertTrue(touching > 200, "frames that press: " + touching);
  }

  /** Returns the mean force of a slide at a constant speed and depth along a direction. */
  private static Vec3 steadyForce(double friction, double depthMm, double mmPerFrame, Vec3 along) {
    MassiveContact body = body(0, friction, friction, 0, new Vec3());
    InteractionPoint point = new InteractionPoint();
    Vec3 target = new Vec3();
    Vec3 force = new Vec3();
    Vec3 mean = new Vec3();
    body.place(point.position);
    for (int frame = 0; frame < 6_000; frame++) {
      double way = Math.max(0, frame - 1_000) * mmPerFrame;
      double deep = depthMm * Math.min(1, frame / 1_000.0);
      Vec3 device =
          new Vec3(way * along.x / SPACINGS[0], way * along.y / SPACINGS[1], -deep / SPACINGS[2]);
      body.move(point, device, MS, target);
      point.contact = target.z < 0;
      point.position.set(target.x, target.y, Math.max(0, target.z));
      body.compute(point, force);
      if (frame >= 4_000) {
        mean.add(force, mean);
      }
    }
    return mean.mul(1.0 / 2_000, mean);
  }

  /**
   * The hand carries friction, mu times the pressing force, the drag of the body, and the spring to
   * the point, which lies a frame behind. That spring leans by the step before friction shortens
   * it, which adds less than a twentieth to the friction.
   */
  @Test
  void aSteadySlideCostsFrictionTimesThePressingForceAgainstTheMotion() {
    double coupling = STIFFNESS * 4 / 3;
    double drag = new MassSettings(0.05, new Vec3()).dragNewtonSecondPerMm(coupling);
    for (Vec3 along : List.of(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(-0.6, 0.8, 0))) {
      for (double friction : new double[] {0, 0.2, 0.5}) {
        Vec3 force = steadyForce(friction, 2, SLOW_MM, along);
        assertEquals(STIFFNESS * 2, force.z, 0.01, "0.6 N/mm, 2 mm deep");
        double against = -force.dot(along);
        double moving = drag * SLOW_MM * 1e3 + 4 * STIFFNESS * SLOW_MM;
        double expected = friction * force.z + moving;
        assertEquals(expected, against, 0.05 * friction * force.z + 1e-6, "friction " + friction);
        Vec3 beside = new Vec3(-along.y, along.x, 0);
        assertEquals(0, force.dot(beside), 1e-6);
      }
    }
  }

  /** Static friction holds the body until the pull of the coupling exceeds its cone. */
  @Test
  void aBodyUnderStaticFrictionStaysUntilThePullLeavesTheCone() {
    MassiveContact body = body(0, 0.52, 0.4, 0, new Vec3());
    InteractionPoint point = new InteractionPoint();
    Vec3 target = new Vec3();
    Vec3 force = new Vec3();
    body.place(point.position);
    double broke = 0;
    for (int frame = 0; frame < 6_000 && broke == 0; frame++) {
      double deep = 2 * Math.min(1, frame / 1_000.0);
      double way = Math.max(0, frame - 2_000) * 5e-4;
      body.move(point, new Vec3(way, 0, -deep / SPACINGS[2]), MS, target);
      point.contact = target.z < 0;
      if (frame > 1_500 && target.x > 0.02) {
        broke = way;
      }
      point.position.set(target.x, target.y, Math.max(0, target.z));
      body.compute(point, force);
    }
    double coupling = STIFFNESS * 4 / 3;
    assertEquals(0.52 * STIFFNESS * 2 / coupling, broke, 0.05, "mm of stretch");
  }
}
