package org.palpate.force.effect;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.force.EffectPlan;
import org.palpate.force.EffectSite;
import org.palpate.force.HandState;
import org.palpate.force.HapticEffect;
import org.palpate.force.guide.SegmentDistance;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

class EffectsTest {
  private static final long SEED = Seeds.seed();
  private static final long MS = 1_000_000;
  private static final double STIFFNESS = 0.5;
  private static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(24, 24, 24);

  private final HandState hand = new HandState();
  private final Vec3 force = new Vec3();
  private final Vec3 torque = new Vec3();

  private static HapticEffect made(EffectPlan plan, double maxNewton) {
    return plan.make(
        new EffectSite(
            RigidTransform.identity(), STIFFNESS, 9 * STIFFNESS, maxNewton, List.of(new Vec3())));
  }

  private static HapticEffect made(EffectPlan plan) {
    return made(plan, Double.POSITIVE_INFINITY);
  }

  private Vec3 moveTo(HapticEffect effect, double x, double y, double z) {
    hand.device.translation.set(x, y, z);
    hand.tool.translation.set(x, y, z);
    hand.advance(MS);
    force.set(0, 0, 0);
    torque.set(0, 0, 0);
    effect.add(hand, force, torque);
    return force;
  }

  @Test
  void viscosityIsProportionalToTheSpeedAndBoundedByTheDevice() {
    HapticEffect viscous = made(Effects.viscosity(0.01));
    for (int n = 0; n < 100; n++) {
      moveTo(viscous, 0.05 * n, 0, -0.02 * n);
    }
    assertEquals(-0.01 * 50, force.x, 1e-6);
    assertEquals(0.01 * 20, force.z, 1e-6);
    assertEquals(0, torque.length(), "a point has no torque");
    HapticEffect weak = made(Effects.viscosity(0.01), 0.3);
    assertEquals(0.3, moveTo(weak, 5, 0, -2).length(), 1e-12);
  }

  @Test
  void viscosityOfAToolResistsItsTurn() {
    hand.isRigid = true;
    HapticEffect viscous = made(Effects.viscosity(0.01));
    for (int n = 0; n < 100; n++) {
      hand.device.rotation.setRotationVector(new Vec3(0, 0, 0.002 * n));
      moveTo(viscous, 0, 0, 0);
    }
    assertEquals(-0.01 * 9 * 2, torque.z, 1e-6);
    assertEquals(0, force.length());
  }

  @Test
  void aMagnetPullsMostHalfWayAndLittleAtTheSurface() {
    BitCube wall = new BitCube(24, 24, 24);
    for (int j = 0; j < 24; j++) {
      for (int k = 0; k < 24; k++) {
        wall.set(0, j, k);
      }
    }
    HapticEffect magnet = made(Effects.magnet(new SegmentDistance(wall, GRID, 8), 1.5, 8));
    assertEquals(0, moveTo(magnet, 9.6, 12, 12).length());
    assertEquals(-1.5, moveTo(magnet, 5, 12, 12).x, 1e-3);
    assertEquals(-1.5 * 0.75, moveTo(magnet, 3, 12, 12).x, 1e-3);
    assertEquals(0, moveTo(magnet, 1.001, 12, 12).length(), 0.1);
    double last = 0;
    for (int n = 0; n < 900; n++) {
      double now = moveTo(magnet, 10 - 0.01 * n, 12, 12).x;
      assertTrue(now <= 1e-12 && now >= -1.5 - 1e-9);
      assertTrue(Math.abs(now - last) <= 0.02, "a step at " + (10 - 0.01 * n));
      last = now;
    }
  }

  @Test
  void aMagnetGivesBackNoMoreThanItTook() {
    SplittableRandom random = new SplittableRandom(SEED);
    BitCube ball = new BitCube(24, 24, 24);
    for (int n = 0; n < 24 * 24 * 24; n++) {
      double x = n % 24 - 11.5;
      double y = n / 24 % 24 - 11.5;
      int k = n / 576;
      double z = k - 11.5;
      if (x * x + y * y + z * z < 16) {
        ball.set(n % 24, n / 24 % 24, k);
      }
    }
    HapticEffect magnet = made(Effects.magnet(new SegmentDistance(ball, GRID, 6), 1, 6));
    for (int loop = 0; loop < 10; loop++) {
      double turn = random.nextDouble() * 6;
      double sum = 0;
      double work = 0;
      Vec3 last = new Vec3(Double.NaN, 0, 0);
      for (int n = 0; n <= 4000; n++) {
        double angle = 2 * Math.PI * n / 4000;
        Vec3 at = new Vec3(12 + 8 * Math.cos(angle), 12 + 3 * Math.sin(angle + turn), 17);
        double done = moveTo(magnet, at.x, at.y, at.z).dot(at.sub(last, new Vec3()));
        work += Double.isNaN(done) ? 0 : done;
        sum += Double.isNaN(done) ? 0 : Math.abs(done);
        last.set(at);
      }
      assertTrue(sum > 0.1, "seed " + SEED);
      assertEquals(0, work, 0.03 * sum, "seed " + SEED);
    }
  }

  @Test
  void aStuckHandFeelsASpringUntilItSlips() {
    HapticEffect sticky = made(Effects.stickSlip(1));
    hand.contact = true;
    hand.contactNewton.set(0, 0, 2);
    moveTo(sticky, 0, 0, 0);
    assertEquals("(-0.75, 0.0, 0.0)", moveTo(sticky, 1.5, 0, 0).toString());
    assertEquals(0, moveTo(sticky, 1.5, 0, -3).z, "across the surface nothing sticks");
    assertEquals(-0.75, force.x);
    double last = moveTo(sticky, 1.9, 0, 0).x;
    boolean slipped = false;
    for (int n = 1; n < 400; n++) {
      double now = moveTo(sticky, 1.9 + 0.02 * n, 0, 0).x;
      slipped |= now > -0.3;
      assertTrue(now <= 0 && now >= -1 && Math.abs(now - last) < 0.25, "frame " + n + ": " + now);
      last = now;
    }
    assertTrue(slipped);
  }

  @Test
  void nothingSticksWithoutContact() {
    HapticEffect sticky = made(Effects.stickSlip(1));
    moveTo(sticky, 0, 0, 0);
    assertEquals(0, moveTo(sticky, 1.5, 0, 0).length());
    hand.contact = true;
    assertEquals(-0.5, moveTo(sticky, 2.5, 0, 0).x);
    hand.contact = false;
    double last = 0.5;
    for (int n = 0; n < 60; n++) {
      double now = -moveTo(sticky, 2.5 + n, 0, 0).x;
      assertTrue(now < last && now >= 0);
      last = now;
    }
    assertTrue(last < 1e-4);
  }

  @Test
  void aVibrationIsASineNoLongerThanThePressingForce() {
    HapticEffect drill = made(Effects.vibration(50, 0.4));
    hand.contactNewton.set(0, 3, 4);
    for (int n = 1; n <= 100; n++) {
      moveTo(drill, 0, 0, 0);
      // The first frame has no time yet.
      double sine = Math.sin(2 * Math.PI * 50 * 0.001 * n);
      assertEquals(0.4 * sine * 0.8, force.z, 1e-9, "frame " + n);
      assertEquals(0.4 * sine * 0.6, force.y, 1e-9);
    }
    hand.contactNewton.set(0, 0, 0.1);
    for (int n = 0; n < 40; n++) {
      assertTrue(moveTo(drill, 0, 0, 0).length() <= 0.1 + 1e-12);
    }
    hand.contactNewton.set(0, 0, 0);
    assertEquals(0, moveTo(drill, 0, 0, 0).length());
  }

  private static ScalarVolume ripples(double perVoxel) {
    ScalarVolume grey = ScalarVolume.of(GRID, ScalarVolume.Storage.FLOAT32);
    for (int k = 0; k < 24; k++) {
      for (int j = 0; j < 24; j++) {
        for (int i = 0; i < 24; i++) {
          grey.set(i, j, k, 100 * Math.sin(perVoxel * i));
        }
      }
    }
    return grey;
  }

  @Test
  void aTexturePushesBackUphillAndForwardsDownhill() {
    HapticEffect texture = made(Effects.texture(ripples(0.8), 0.002));
    hand.contactNewton.set(0, 0, 3);
    double up = moveTo(texture, 8 + 0.5, 12, 12).x; // sin(6.4) rises
    double down = moveTo(texture, 4 + 0.5, 12, 12).x; // sin(3.2) falls
    assertTrue(up < -0.01, "uphill " + up);
    assertTrue(down > 0.01, "downhill " + down);
    assertEquals(0, Math.hypot(force.y, force.z), 1e-9);
    hand.contactNewton.set(0, 0, 0);
    assertEquals(0, moveTo(texture, 8.5, 12, 12).length());
  }

  @Test
  void aTextureIsBoundedAndHasNoSteps() {
    SplittableRandom random = new SplittableRandom(SEED);
    ScalarVolume grey = ScalarVolume.of(GRID, ScalarVolume.Storage.INT16);
    for (int n = 0; n < 24 * 24 * 24; n++) {
      grey.set(n % 24, n / 24 % 24, n / 576, random.nextInt(2000) - 1000);
    }
    HapticEffect texture = made(Effects.texture(grey, 0.01));
    hand.contactNewton.set(0, 1, 2);
    Vec3 last = new Vec3();
    for (int n = 0; n < 5000; n++) {
      moveTo(texture, -2 + 0.005 * n, 12 + Math.sin(0.001 * n), 11);
      assertTrue(force.length() <= 0.5 * Math.sqrt(5) + 1e-9);
      assertTrue(Math.abs(force.dot(hand.contactNewton)) < 1e-9, "along the surface alone");
      if (n > 0) {
        assertTrue(force.sub(last, last).length() < 0.35, "seed " + SEED + " frame " + n);
      }
      last.set(force);
    }
  }

  @Test
  void aTextureOfValuesWithoutDetailIsNotFelt() {
    ScalarVolume grey = ScalarVolume.of(GRID, ScalarVolume.Storage.INT16);
    for (int n = 0; n < 24 * 24 * 24; n++) {
      grey.set(n % 24, n / 24 % 24, n / 576, 40 * (n % 24) - 7 * (n / 576));
    }
    HapticEffect texture = made(Effects.texture(grey, 0.01));
    hand.contactNewton.set(0, 1, 2);
    assertEquals(0, moveTo(texture, 8.3, 9.1, 12.7).length(), 1e-9);
  }

  /** The lever of the coupling is 3 mm, so that a rotation has 9 times the drag in N mm s. */
  @Test
  void viscosityBrakesTheTurnOfARigidToolAtTheLeverOfTheCoupling() {
    HapticEffect viscous = made(Effects.viscosity(0.002), 0.5);
    hand.isRigid = true;
    hand.spinRadPerSecond.set(0, 0, 4);
    viscous.add(hand, force.set(0, 0, 0), torque.set(0, 0, 0));
    assertEquals(-0.002 * 9 * 4, torque.z, 1e-12);
    assertEquals(0, force.length());
    hand.spinRadPerSecond.set(0, 400, 0);
    viscous.add(hand, force.set(0, 0, 0), torque.set(0, 0, 0));
    assertEquals(-0.5 * 3, torque.y, 1e-12, "at most the longest force at the lever");
  }
}
