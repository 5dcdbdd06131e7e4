package org.palpate.force;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;

class ForceLimiterTest {
  private static final long SEED = Long.getLong("palpate.seed", 20130613);
  private static final long MS = 1_000_000;
  private static final double NONE = Double.POSITIVE_INFINITY;

  @Test
  void shortensTheForceAndKeepsItsDirection() {
    Vec3 force = new Vec3(30, 0, 40);
    new ForceLimiter(5, NONE).clamp(force, MS);
    assertEquals(3, force.x, 1e-14);
    assertEquals(4, force.z, 1e-14);
  }

  @Test
  void keepsTheBitsOfAForceBelowTheMaximum() {
    Vec3 force = new Vec3(0.1, 0.2, 0.3);
    new ForceLimiter(5, NONE).clamp(force, MS);
    assertTrue(force.sameBits(new Vec3(0.1, 0.2, 0.3)));
  }

  @Test
  void aForceThatIsNotFiniteBecomesZeroAndIsCounted() {
    ForceLimiter limiter = new ForceLimiter(5, NONE);
    for (double bad : new double[] {Double.NaN, NONE, -NONE}) {
      Vec3 force = new Vec3(1, bad, 2);
      limiter.clamp(force, MS);
      assertEquals(0, force.length());
    }
    assertEquals(3, limiter.notFinite());
  }

  @Test
  void neverExceedsTheMaximumByABit() {
    SplittableRandom random = new SplittableRandom(SEED);
    ForceLimiter limiter = new ForceLimiter(3.3, 0.7);
    for (int run = 0; run < 200_000; run++) {
      Vec3 force = new Vec3(wild(random), wild(random), wild(random));
      limiter.clamp(force, (random.nextLong() >>> 1) % (20 * MS));
      assertTrue(
          force.isFinite() && force.length() <= 3.3, "seed=" + SEED + " run=" + run + " " + force);
    }
  }

  @Test
  void changesNoFasterThanTheSlew() {
    SplittableRandom random = new SplittableRandom(SEED);
    ForceLimiter limiter = new ForceLimiter(NONE, 0.5);
    Vec3 last = new Vec3();
    for (int run = 0; run < 100_000; run++) {
      Vec3 force = new Vec3(unit(random) * 9, unit(random) * 9, unit(random) * 9);
      long elapsed = (random.nextLong() >>> 1) % (4 * MS);
      limiter.clamp(force, elapsed);
      double change = force.sub(last, new Vec3()).length();
      assertTrue(
          change <= 0.5e-6 * elapsed * (1 + 1e-9) + 1e-14,
          "seed=" + SEED + " run=" + run + " change=" + change);
      last.set(force);
    }
  }

  @Test
  void reachesAConstantForceAndStaysThereBitForBit() {
    ForceLimiter limiter = new ForceLimiter(NONE, 0.5);
    Vec3 force = new Vec3();
    for (int frame = 0; frame < 6; frame++) {
      force.set(1, -1, 0.3);
      limiter.clamp(force, MS);
    }
    assertTrue(force.sameBits(new Vec3(1, -1, 0.3)), force.toString());
  }

  @Test
  void aPauseOrABackwardClockPermitsNoJump() {
    ForceLimiter limiter = new ForceLimiter(NONE, 0.5);
    Vec3 force = new Vec3(100, 0, 0);
    limiter.clamp(force, 10_000 * MS);
    assertEquals(0.5 * ForceLimiter.MAX_STEP_MS, force.x);
    force.set(100, 0, 0);
    limiter.clamp(force, -MS);
    assertEquals(0.5 * ForceLimiter.MAX_STEP_MS, force.x);
  }

  @Test
  void afterAResetTheForceGrowsFromZero() {
    ForceLimiter limiter = new ForceLimiter(NONE, 0.5);
    Vec3 force = new Vec3(2, 0, 0);
    limiter.clamp(force, 5 * MS);
    limiter.reset();
    force.set(2, 0, 0);
    limiter.clamp(force, MS);
    assertEquals(0.5, force.x);
  }

  @Test
  void aRampRisesFromZeroToOne() {
    ForceRamp ramp = new ForceRamp(100);
    assertEquals(1, ramp.factor());
    ramp.start();
    assertEquals(0, ramp.factor());
    ramp.advance(25);
    ramp.advance(-50);
    assertEquals(0.25, ramp.factor());
    ramp.advance(Long.MAX_VALUE);
    assertEquals(1, ramp.factor());
  }

  @Test
  void limitsOutOfRangeAreRefusedWithTheirValue() {
    String message =
        assertThrows(IllegalArgumentException.class, () -> new ForceLimiter(-1, 1)).getMessage();
    assertTrue(message.endsWith("maxForceNewton=-1.0 slewNewtonPerMs=1.0"), message);
    assertThrows(IllegalArgumentException.class, () -> new ForceLimiter(1, Double.NaN));
    assertThrows(IllegalArgumentException.class, () -> new ForceRamp(-1));
  }

  private static double unit(SplittableRandom random) {
    return (random.nextLong() >>> 11) * 0x1p-52 - 1;
  }

  private static double wild(SplittableRandom random) {
    return unit(random) * StrictMath.pow(10, unit(random) * 308);
  }
}
