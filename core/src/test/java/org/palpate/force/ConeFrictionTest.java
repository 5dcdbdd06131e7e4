package org.palpate.force;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;

class ConeFrictionTest {
  private static final long SEED = Long.getLong("palpate.seed", 20130613);
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);
  private static final double MU = 0.4;
  private static final double PRESSING = 3;
  private static final MaterialTransition FELT =
      new MaterialTransition(1, Material.of(1, MU, FrictionForm.CONE));

  private final ConeFriction cone = new ConeFriction(UNIT);
  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();
  private final Vec3 force = new Vec3();

  @Test
  void sticksInsideTheStaticConeAndSlidesWithLessBeyond() {
    press(0);
    double most = 0;
    for (int frame = 1; frame <= 300; frame++) {
      press(0.01 * frame);
      most = Math.max(most, -force.x);
    }
    assertTrue(cone.isSliding());
    assertEquals(MU * PRESSING, most, 0.011);
    assertEquals(-ConeFriction.SLIDING_FRACTION * MU * PRESSING, force.x, 1e-12);
  }

  @Test
  void pullsLikeASpringWhileItSticks() {
    press(0);
    press(0.2);
    press(0.5);
    assertFalse(cone.isSliding());
    assertEquals(-0.5, force.x, 1e-12);
  }

  @Test
  void sticksAgainWhereASlideStops() {
    press(0);
    for (int frame = 1; frame <= 300; frame++) {
      press(0.01 * frame);
    }
    press(3);
    assertFalse(cone.isSliding());
  }

  @Test
  void releasesTheAnchorWithoutContact() {
    press(0);
    press(0.5);
    point.contact = false;
    force.set(0, 0, 0);
    cone.add(point, device, FELT, force);
    assertEquals(0, force.length());
    press(0.5);
    assertEquals(0, force.x);
  }

  @Test
  void neverPushesInTheDirectionOfTheHand() {
    SplittableRandom random = new SplittableRandom(SEED);
    double x = 0;
    double y = 0;
    for (int frame = 0; frame < 20000; frame++) {
      double dx = 0.1 * (random.nextDouble() - 0.5);
      double dy = 0.1 * (random.nextDouble() - 0.5);
      x += dx;
      y += dy;
      pressAt(x, y);
      assertTrue(force.x * dx + force.y * dy <= 1e-15, "frame " + frame + " seed=" + SEED);
    }
  }

  private void press(double x) {
    pressAt(x, 0);
  }

  private void pressAt(double x, double y) {
    point.position.set(x, y, 0);
    device.set(x, y, -PRESSING);
    point.contact = true;
    force.set(0, 0, PRESSING);
    cone.add(point, device, FELT, force);
  }
}
