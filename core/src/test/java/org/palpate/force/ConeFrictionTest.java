package org.palpate.force;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.testing.RandomGeometry;

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

  /**
   * Turns a press and its motion, and measures it in other voxels: the force must turn with it. The
   * unturned press is that of the other tests.
   */
  @Test
  void isTheSameInEveryDirectionAndInVoxelsOfEveryShape() {
    SplittableRandom random = new SplittableRandom(SEED);
    for (int run = 0; run < 20; run++) {
      Quaternion turn = RandomGeometry.pose(random, 1).rotation;
      GridMetric voxels = new GridMetric(0.5, 2, 1 + random.nextDouble());
      ConeFriction turned = new ConeFriction(voxels);
      InteractionPoint at = new InteractionPoint();
      at.contact = true;
      double x = 0;
      double y = 0;
      for (int frame = 0; frame < 100; frame++) {
        x += random.nextDouble(-0.05, 0.15);
        y += random.nextDouble(-0.1, 0.1);
        pressAt(x, y);
        Vec3 expected = turn.rotate(force, new Vec3());
        toVoxels(turn.rotate(point.position, new Vec3()), voxels, at.position);
        Vec3 hand = toVoxels(turn.rotate(device, new Vec3()), voxels, new Vec3());
        Vec3 felt = turn.rotate(new Vec3(0, 0, PRESSING), new Vec3());
        turned.add(at, hand, FELT, felt);
        double off = expected.sub(felt, new Vec3()).length();
        assertEquals(0, off, 1e-9, "run " + run + " frame " + frame + " seed=" + SEED);
        assertEquals(cone.isSliding(), turned.isSliding());
      }
      point.contact = false;
      cone.add(point, device, FELT, force);
      point.contact = true;
    }
  }

  private static Vec3 toVoxels(Vec3 mm, GridMetric voxels, Vec3 dest) {
    return dest.set(mm.x / voxels.spacingX(), mm.y / voxels.spacingY(), mm.z / voxels.spacingZ());
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
