package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;

/** Plants springs that return more work than they took, along a line and in space. */
class EnergyTankTest {
  private static final double COUPLING = 0.5;

  private final Random random = new Random(Seeds.seed());
  private final EnergyTank tank = new EnergyTank();
  private final Vec3 device = new Vec3(0, 0, 1);
  private final Vec3 last = new Vec3().set(device);
  private final Vec3 lastForce = new Vec3();
  private final Vec3 force = new Vec3();
  private double taken;
  private double returned;
  private double largestStep;

  /** Moves the device and limits a planted force; sums the work as the definition says. */
  private void step(double x, double z, double newtonX, double newtonZ) {
    device.set(x, 0, z);
    force.set(newtonX, 0, newtonZ);
    tank.limit(device, Math.max(0, -z), COUPLING, force);
    Vec3 motion = device.sub(last, new Vec3());
    double work = 0.5 * (lastForce.dot(motion) + force.dot(motion));
    taken += Math.max(0, -work);
    returned += Math.max(0, work);
    double change = force.sub(lastForce, new Vec3()).length();
    largestStep = Math.max(largestStep, change - COUPLING * motion.length());
    last.set(device);
    lastForce.set(force);
  }

  private void press(double from, double to, double mm, double newtonPerMm) {
    int frames = (int) Math.round(Math.abs(to - from) / mm);
    for (int n = 1; n <= frames; n++) {
      double z = from + (to - from) * n / frames;
      step(0, z, 0, newtonPerMm * Math.max(0, -z));
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.001, 0.06, 0.2})
  void leavesASpringAlone(double mm) {
    step(0, 1, 0, 0);
    for (int cycle = 0; cycle < 20; cycle++) {
      press(1, -4, mm, 0.3);
      press(-4, 1, mm, 0.3);
    }
    assertEquals(0, tank.loweredFrames());
    assertEquals(taken, returned, 1e-9);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.001, 0.06, 0.2})
  void takesTheGainFromAReleaseThatIsStiffer(double mm) {
    step(0, 1, 0, 0);
    for (int cycle = 0; cycle < 20; cycle++) {
      press(1, -4, mm, 0.3);
      double atDepth = lastForce.z;
      press(-4, -4.0 + mm, mm, 0.33);
      assertTrue(lastForce.z > atDepth, "the force at the depth stays");
      press(-4.0 + mm, 1, mm, 0.33);
    }
    assertTrue(tank.loweredFrames() > 0);
    assertTrue(returned <= 1.01 * taken, returned + " of " + taken);
    assertTrue(returned > 0.9 * taken, returned + " of " + taken);
  }

  @Test
  void lowersAForceByNoMoreThanTheCouplingWould() {
    step(0, 1, 0, 0);
    press(1, -4, 0.06, 0.3);
    largestStep = 0;
    for (int n = 0; n < 100; n++) {
      step(0, -4, 0, 1.2 * (1 + 0.1 * n / 100)); // The material becomes stiffer at rest.
    }
    assertTrue(largestStep <= 1.2 * 0.1 / 100 + 1e-12, "planted steps, " + largestStep);
    largestStep = 0;
    press(-4, 1, 0.06, 0.33);
    assertTrue(tank.loweredFrames() > 0);
    assertTrue(largestStep < 0.13 * COUPLING * 0.06, "step " + largestStep);
  }

  /** The last motion before the hand is free is long, and the force over it counts by its mean. */
  @ParameterizedTest
  @ValueSource(doubles = {0.3, 0.5, 0.8, 1.2})
  void aFastReleaseOutOfStepWithThePressGainsNothing(double mm) {
    double worst = 0;
    for (int n = 0; n < 100; n++) {
      step(0, 1, 0, 0);
      taken = 0;
      returned = 0;
      press(0.01 * n * mm, -4, mm, COUPLING);
      press(-4, 1, mm * (0.5 + 0.01 * n), COUPLING);
      worst = Math.max(worst, returned / taken);
    }
    assertTrue(worst <= EnergyTank.RETURNED_PER_TAKEN + 1e-9, "gain " + worst);
  }

  @Test
  void aForceFromRestNeedsNoWorkOnlyWhereThePointWasPlacedAnew() {
    tank.restart();
    step(0, -4, 0, 1.2);
    assertEquals(1.2, force.z);
    step(0, 1, 0, 0);
    step(0, -4, 0, 0);
    step(0, -4, 0, 1.2);
    assertEquals(0, force.z, "no motion built it up");
  }

  /** Material that gives way holds no more work than its force does along the path. */
  @Test
  void workThatTheMaterialCannotHoldIsLost() {
    step(0, 1, 0, 0);
    press(1, -4, 0.06, 0.3);
    step(0, -4, 0, 0.12);
    step(0, -4, 0, 1.2);
    double held = 0.12 * 4;
    double spring = 1.2 * 1.2 / (2 * COUPLING);
    assertEquals(1.2 * Math.sqrt(held / spring), force.z, 1e-9);
  }

  /** The last force has returned more than the tank held, but the next one takes work. */
  @Test
  void aHandThatPressesOnFeelsAForceAlthoughTheTankIsOverdrawn() {
    tank.restart();
    step(0, -0.01, 0, 0.1);
    step(-1, 0.49, 1, 0);
    double before = 0.5 * 0.1 * 0.01 - 0.5 * 0.1 * 0.5;
    double byNext = 0.5;
    double spring = 1 / (2 * COUPLING);
    double part = force.x;
    assertEquals(before + part * byNext, part * part * spring, 1e-12, "as much as is held");
    assertTrue(part > 0.4, "part " + part);
  }

  @Test
  void noForceIsLeftIfTheTankStaysOverdrawnThoughTheHandPressesOn() {
    tank.restart();
    step(0, -0.01, 0, 0.1);
    step(-1, 0.49, 0.04, 0);
    double before = 0.5 * 0.1 * 0.01 - 0.5 * 0.1 * 0.5;
    assertTrue(before + 0.5 * 0.04 < 0, "all of the force leaves the tank overdrawn");
    assertEquals(0, force.x);
  }

  /** Forces follow the depth by a stiffness that changes at random. */
  @Test
  void noWalkFromFreeToFreeGains() {
    step(0, 1, 0, 0);
    for (int walk = 0; walk < 300; walk++) {
      taken = 0;
      returned = 0;
      double z = 1;
      double x = 0;
      double stiffness = 0.1 + 0.3 * random.nextDouble();
      for (int n = 0; n < 2000 || z < 0; n++) {
        double goal = n < 1500 ? -6 * random.nextDouble() : 1;
        z += 0.1 * random.nextDouble() * (goal > z ? 1 : -1);
        x += 0.02 * random.nextGaussian();
        stiffness = Math.max(0.05, Math.min(0.45, stiffness + 0.003 * random.nextGaussian()));
        double newton = stiffness * Math.max(0, -z);
        double tilt = 0.2 * random.nextGaussian();
        step(x, z, newton * tilt, newton * (1 - Math.abs(tilt)));
      }
      step(x, 1, 0, 0);
      assertTrue(returned <= 1.01 * taken, "walk " + walk + ": " + returned + " of " + taken);
    }
  }
}
