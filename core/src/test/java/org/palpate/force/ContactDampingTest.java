package org.palpate.force;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;

class ContactDampingTest {
  private static final double NEWTON_S_PER_MM = 0.002;
  private static final long MS = 1_000_000;
  private static final double TOLERANCE = 1e-12;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final GridMetric metric = new GridMetric(0.5, 2, 3);
  private final ContactDamping damping = new ContactDamping(metric);
  private final Vec3 device = new Vec3();

  /** The speed as the class describes it, mm/s, each axis for itself. */
  private final double[] speed = new double[3];

  /** Moves the device by some mm, and the reference speed by its share towards that motion. */
  private void move(Vec3 motionMm, double ms) {
    device.set(device.x + motionMm.x / 0.5, device.y + motionMm.y / 2, device.z + motionMm.z / 3);
    damping.update(device, (long) (ms * MS));
    for (int axis = 0; axis < 3 && ms > 0; axis++) {
      double share = ms / (ContactDamping.SMOOTHING_MS + ms);
      speed[axis] = (1 - share) * speed[axis] + share * motionMm.get(axis) / (ms * 1e-3);
    }
  }

  private double inwardMmPerS(Vec3 coupling) {
    Vec3 velocity = new Vec3(speed[0], speed[1], speed[2]);
    return -velocity.dot(coupling) / coupling.length();
  }

  @Test
  void followsTheSmoothedSpeedAlongTheCouplingInMillimetres() {
    damping.update(device, MS);
    for (int n = 0; n < 200; n++) {
      move(RandomGeometry.vector(random, 0.05), random.nextInt(1, 5));
      Vec3 coupling = RandomGeometry.vector(random, 4);
      double most = coupling.length();
      double newton = NEWTON_S_PER_MM * inwardMmPerS(coupling);
      double expected = Math.max(-most, Math.min(most, newton));
      assertEquals(expected, damping.newton(coupling, NEWTON_S_PER_MM), TOLERANCE);
      Vec3 force = new Vec3();
      damping.compute(coupling, NEWTON_S_PER_MM, force);
      assertEquals(expected * most, force.dot(coupling), 1e-9);
      assertEquals(Math.abs(expected), force.length(), TOLERANCE);
    }
  }

  @Test
  void isNeverLongerThanTheCouplingEitherWay() {
    damping.update(device, MS);
    Vec3 coupling = new Vec3(0, 0, 0.1);
    move(new Vec3(0, 0, -50), 1);
    assertEquals(0.1, damping.newton(coupling, 1));
    move(new Vec3(0, 0, 500), 1);
    assertEquals(-0.1, damping.newton(coupling, 1));
    assertEquals(0, damping.newton(new Vec3(), 1));
    Vec3 force = new Vec3(1, 1, 1);
    damping.compute(new Vec3(), 1, force);
    assertEquals(0, force.length());
  }

  @Test
  void keepsItsSpeedWithoutTimeAndForgetsItOnRequest() {
    damping.update(device, MS);
    move(new Vec3(0, 0, -0.1), 1);
    Vec3 coupling = new Vec3(0, 0, 5);
    double before = damping.newton(coupling, NEWTON_S_PER_MM);
    assertEquals(NEWTON_S_PER_MM * 100 / 5, before, TOLERANCE);
    move(new Vec3(0, 0, 7), 0);
    assertEquals(before, damping.newton(coupling, NEWTON_S_PER_MM));
    damping.reset();
    damping.update(new Vec3(9, 9, 9), MS);
    assertEquals(0, damping.newton(coupling, NEWTON_S_PER_MM), TOLERANCE);
  }
}
