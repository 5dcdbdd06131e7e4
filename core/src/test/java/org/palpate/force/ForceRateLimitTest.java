package org.palpate.force;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;

class ForceRateLimitTest {
  private static final GridMetric CT = new GridMetric(0.5, 0.5, 1);
  private static final double STIFFNESS = 2;

  private final ContactForce contact = new ContactForce(CT, ForceSettings.of(STIFFNESS, 0));
  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();
  private final Vec3 force = new Vec3();
  private final Vec3 last = new Vec3();

  @Test
  void aJumpOfThePointBuildsUpWhileTheDeviceRests() {
    point.limitsForceRate = true;
    point.position.set(0, 0, 1);
    contact.compute(point, device, force);
    point.position.set(0, 4, 1);
    int frames = 0;
    double most = 1.5 * STIFFNESS * 0.05 * 0.5;
    do {
      last.set(force);
      contact.compute(point, device, force);
      frames++;
      assertTrue(distance(force, last) <= most * (1 + 1e-12), "frame " + frames);
    } while (!force.sameBits(last));
    assertEquals("(0.0, 4.0, 2.0)", force.toString());
    assertEquals((int) Math.ceil(4 / most) + 1, frames);
  }

  @Test
  void aForceThatFollowsTheDeviceIsNotLimited() {
    point.limitsForceRate = true;
    for (int frame = 0; frame < 100; frame++) {
      device.set(0.3 * frame, 0, -0.01 * frame * frame);
      point.position.set(0.3 * frame, 0, 0);
      contact.compute(point, device, force);
      assertEquals(STIFFNESS * 0.01 * frame * frame, force.z, 1e-12);
    }
  }

  @Test
  void aSolverThatDoesNotAskForTheLimitMayJump() {
    point.position.set(0, 0, 1);
    contact.compute(point, device, force);
    point.position.set(0, 4, 1);
    contact.compute(point, device, force);
    assertEquals("(0.0, 4.0, 2.0)", force.toString());
  }

  private static double distance(Vec3 a, Vec3 b) {
    return a.sub(b, new Vec3()).length();
  }
}
