package org.palpate.force;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.testing.Seeds;

class MassiveContactTest {
  private static final long SEED = Seeds.seed();
  private static final GridMetric METRIC = new GridMetric(1, 0.5, 2);
  private static final double STIFFNESS = 0.6;

  /** The stiffness of the spring to the device, N/mm, that the class documents. */
  private static final double COUPLING = STIFFNESS * 4 / 3;

  private static final long MS = 1_000_000;

  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();
  private final Vec3 target = new Vec3();
  private final Vec3 force = new Vec3();

  private static MassiveContact body(double kg, double friction, Vec3 gravity) {
    return new MassiveContact(
        METRIC, ForceSettings.of(STIFFNESS, friction), new MassSettings(kg, gravity));
  }

  /** Runs a frame in which nothing is in the way of the point. */
  private void freeFrame(MassiveContact body, long nanos) {
    body.move(point, device, nanos, target);
    point.position.set(target);
    body.compute(point, force);
  }

  /** Runs a frame in which a floor at z = 0 holds the point. */
  private void frameOnFloor(MassiveContact body) {
    body.move(point, device, MS, target);
    point.position.set(target.x, target.y, Math.max(0, target.z));
    point.contact = target.z < 0;
    body.compute(point, force);
  }

  @Test
  void fallsOnItsSpringAsAnOscillatorDoesAndRestsWhereTheSpringCarriesIt() {
    double kg = 0.05;
    MassiveContact body = body(kg, 0, new Vec3(0, 0, -9810));
    body.place(point.position);
    double omega = Math.sqrt(COUPLING * 1e3 / kg);
    double decay = MassSettings.DAMPING_RATIO * omega;
    double swing = omega * Math.sqrt(1 - MassSettings.DAMPING_RATIO * MassSettings.DAMPING_RATIO);
    double sag = kg * 9.81 / COUPLING;
    long step = MS / 100;
    freeFrame(body, 0);
    for (int n = 1; n <= 10_000; n++) {
      freeFrame(body, step);
      double t = n * 1e-5;
      double expected =
          sag
              * (1
                  - Math.exp(-decay * t)
                      * (Math.cos(swing * t) + decay / swing * Math.sin(swing * t)));
      assertEquals(-expected, 2 * target.z, 5e-3 * sag, "at " + t + " s");
      assertEquals(-COUPLING * expected, force.z, 5e-3 * kg * 9.81);
    }
    for (int n = 0; n < 5000; n++) {
      freeFrame(body, MS);
    }
    assertEquals(-kg * 9.81, force.z, 1e-6);
    assertEquals(0, force.x);
  }

  @Test
  void restsBitForBitInFreeSpaceAndOnASurface() {
    for (double kg : new double[] {0.005, 0.05, 1}) {
      for (double deviceZ : new double[] {3, -1.7}) {
        MassiveContact body = body(kg, 0.2, new Vec3(0, 0, -9810));
        point.position.set(0, 0, 4);
        body.place(point.position);
        device.set(0.3, -5, deviceZ);
        for (int n = 0; n < 20_000; n++) {
          frameOnFloor(body);
        }
        Vec3 rested = new Vec3().set(target);
        Vec3 felt = new Vec3().set(force);
        for (int n = 0; n < 1000; n++) {
          frameOnFloor(body);
          assertTrue(target.sameBits(rested), kg + " kg at " + deviceZ + " frame " + n);
          assertTrue(force.sameBits(felt));
        }
      }
    }
  }

  @Test
  void aSurfaceIsAsStiffAsItsMaterialWhateverTheMass() {
    for (double kg : new double[] {0.005, 0.3, 1}) {
      MassiveContact body = body(kg, 0, new Vec3());
      point.position.set(0, 0, 1);
      body.place(point.position);
      for (double depthMm : new double[] {0.5, 2, 7}) {
        device.set(0, 0, -depthMm / METRIC.spacingZ());
        for (int n = 0; n < 8000; n++) {
          frameOnFloor(body);
        }
        assertEquals(STIFFNESS * depthMm, force.z, 1e-6, kg + " kg");
      }
    }
  }

  @Test
  void theHeightOfTheSurfaceIsNotFelt() {
    MassiveContact body = body(0.05, 0, new Vec3());
    point.position.set(0, 0, 1);
    point.surfaceHeightMm = 0.4;
    body.place(point.position);
    device.set(0, 0, -1);
    for (int n = 0; n < 8000; n++) {
      frameOnFloor(body);
    }
    assertEquals(STIFFNESS * (2 - 0.4), force.z, 1e-6);
  }

  @Test
  void aSpringOfNoStiffnessIsNotFelt() {
    MassiveContact body =
        new MassiveContact(METRIC, ForceSettings.of(0, 0.2), new MassSettings(0.05, new Vec3()));
    point.position.set(0, 0, 1);
    body.place(point.position);
    device.set(0, 0, -1);
    for (int n = 0; n < 100; n++) {
      frameOnFloor(body);
      assertEquals(0, force.length());
    }
  }

  @Test
  void frictionHoldsTheBodyUntilTheConeAndThenOpposesTheSlide() {
    MassiveContact body = body(0.02, 0.5, new Vec3());
    point.position.set(0, 0, 1);
    body.place(point.position);
    device.set(0, 0, -2);
    for (int n = 0; n < 8000; n++) {
      frameOnFloor(body);
    }
    double pressing = force.z;
    double slips = 0.5 * pressing / COUPLING;
    device.set(0.9 * slips, 0, -2);
    for (int n = 0; n < 8000; n++) {
      frameOnFloor(body);
    }
    assertEquals(0, point.position.x, 2e-3);
    assertEquals(-0.9 * 0.5 * pressing, force.x, 2e-3);
    device.set(3 * slips, 0, -2);
    for (int n = 0; n < 8000; n++) {
      frameOnFloor(body);
    }
    assertTrue(point.position.x > 0.5 * slips, "slid to " + point.position);
    assertTrue(-force.x <= 0.5 * pressing * (1 + 1e-6), "force " + force);
  }

  @Test
  void theHandNeverGetsMoreEnergyThanItGave() {
    long frames = Long.getLong("palpate.massFrames", 400_000);
    SplittableRandom random = new SplittableRandom(SEED);
    for (double kg : new double[] {0.005, 0.05, 1}) {
      ForceSettings stiff = ForceSettings.of(2, random.nextInt(2) * 0.3);
      MassiveContact body = new MassiveContact(METRIC, stiff, new MassSettings(kg, new Vec3()));
      point.position.set(0, 0, 1);
      body.place(point.position);
      device.set(point.position);
      frameOnFloor(body);
      Vec3 speed = new Vec3();
      Vec3 last = new Vec3();
      double given = 0;
      for (long n = 0; n < frames; n++) {
        last.set(device);
        for (int axis = 0; axis < 3; axis++) {
          double jolt = random.nextInt(500) == 0 ? 2 : 0.02;
          double pull = -0.002 * device.get(axis);
          speed.set(axis, 0.98 * speed.get(axis) + pull + jolt * (random.nextDouble() - 0.5));
          device.set(axis, device.get(axis) + (random.nextInt(4) == 0 ? 0 : speed.get(axis)));
        }
        frameOnFloor(body);
        double x = (device.x - last.x) * METRIC.spacingX();
        double y = (device.y - last.y) * METRIC.spacingY();
        double z = (device.z - last.z) * METRIC.spacingZ();
        given -= force.x * x + force.y * y + force.z * z;
        if (given < -1e-9 * n) {
          fail("seed " + SEED + " frame " + n + ": " + given + " mJ");
        }
      }
      assertTrue(given > 1, "the hand worked: " + given);
      assertEquals(0, body.debtMillijoule(), 1e-6);
    }
  }

  @Test
  void theObserverTakesASurplusThatAJumpOfThePointMade() {
    MassiveContact body = body(0.05, 0, new Vec3());
    point.position.set(0, 0, 1);
    body.place(point.position);
    device.set(0, 0, 1);
    frameOnFloor(body);
    device.set(0, 0, -2);
    for (int n = 0; n < 20; n++) {
      frameOnFloor(body);
    }
    assertEquals(0, body.takenMillijoule(), 1e-9);
    body.move(point, device, MS, target);
    point.position.set(0, 0, 3); // as if an edit had raised the floor by 6 mm
    point.contact = true;
    body.compute(point, force);
    double owed = body.debtMillijoule() + body.takenMillijoule();
    assertTrue(owed > 1, "surplus of " + owed + " mJ");
    for (int n = 0; n < 5000; n++) {
      body.move(point, device, MS, target);
      body.compute(point, force);
    }
    assertTrue(body.takenMillijoule() > 0);
    assertTrue(body.debtMillijoule() < owed);
  }

  @Test
  void hugePositionsLeaveATargetThatIsFinite() {
    MassiveContact body = body(0.05, 0.2, new Vec3());
    body.place(point.position);
    for (double far : new double[] {1e150, -1e300, 1.7e308, 3}) {
      device.set(far, -far, far);
      for (int n = 0; n < 20; n++) {
        freeFrame(body, MS);
        assertTrue(target.isFinite(), "device at " + far);
      }
    }
    for (int n = 0; n < 4000; n++) {
      freeFrame(body, MS);
    }
    assertEquals(3, target.x, 1e-6);
  }
}
