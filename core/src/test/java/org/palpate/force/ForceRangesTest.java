package org.palpate.force;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;

/** Numbers at the border of their ranges, which a scene file or an option can give. */
class ForceRangesTest {
  private static final double[] REFUSED = {
    -Double.MIN_VALUE, Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY
  };

  private static String refusal(Runnable made) {
    return assertThrows(IllegalArgumentException.class, made::run).getMessage();
  }

  @Test
  void eachFigureOfAMaterialIsAtLeastZeroAndFinite() {
    assertEquals(0, new Material(0, 0, 0, 0).stiffnessNewtonPerMm());
    for (double wrong : REFUSED) {
      assertTrue(refusal(() -> new Material(wrong, 1, 1, 1)).startsWith("stiffness"));
      assertTrue(refusal(() -> new Material(1, wrong, 0, 1)).contains("riction"));
      assertTrue(refusal(() -> new Material(1, 1, wrong, 1)).contains("slidingFriction"));
      assertTrue(refusal(() -> new Material(1, 1, 1, wrong)).contains("amping"));
    }
  }

  @Test
  void slidingFrictionIsAtMostTheStaticOne() {
    assertEquals(0.4, new Material(1, 0.4, 0.4, 0).slidingFriction());
    String refused = refusal(() -> new Material(1, 0.4, Math.nextUp(0.4), 0));
    assertTrue(refused.startsWith("sliding friction must not be larger"), refused);
  }

  @Test
  void aMaterialIsRetunedByAFactorAndASum() {
    Material material = new Material(2, 0.5, 0.4, 0.01);
    assertEquals(new Material(6, 0.75, 0.6000000000000001, 0.01), material.retuned(3, 0.25));
    assertEquals(new Material(2, 0, 0, 0.01), material.retuned(1, -0.9), "at least 0");
    assertEquals(new Material(2, 0.3, 0.3, 0), new Material(2, 0, 0, 0).retuned(1, 0.3));
  }

  @Test
  void aMassIsPositiveAndItsGravityFinite() {
    Vec3 none = new Vec3();
    assertEquals(Double.MIN_VALUE, new MassSettings(Double.MIN_VALUE, none).kg());
    for (double wrong : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
      assertTrue(refusal(() -> new MassSettings(wrong, none)).startsWith("mass must be positive"));
    }
    refusal(() -> new MassSettings(1, new Vec3(0, Double.NaN, 0)));
    MassSettings held = new MassSettings(0.2, new Vec3(0, 0, -9810));
    assertEquals(2e-4, held.newtonSecond2PerMm(), 1e-18);
    assertEquals(-1.962, held.weightNewton().z, 1e-12);
    assertEquals(0, held.weightNewton().x);
  }

  @Test
  void aMassMovesByTheTimeThatPassedAndAtMostByFiveMilliseconds() {
    assertEquals(0.001, MassSettings.stepSeconds(1_000_000));
    assertEquals(0.005, MassSettings.stepSeconds(5_000_000));
    assertEquals(0.005, MassSettings.stepSeconds(900_000_000));
    assertEquals(0, MassSettings.stepSeconds(-7));
  }

  /** The drag is that of an oscillator with the documented ratio to critical damping. */
  @Test
  void theDragGrowsWithTheRootOfStiffnessAndMass() {
    MassSettings held = new MassSettings(0.2, new Vec3());
    double drag = held.dragNewtonSecondPerMm(0.5);
    assertEquals(2 * MassSettings.DAMPING_RATIO * Math.sqrt(0.5 * 2e-4), drag, 1e-15);
    assertEquals(2 * drag, held.dragNewtonSecondPerMm(2), 1e-15);
  }

  @Test
  void aLimiterTakesAMaximumOfZeroButNoSlewOfZero() {
    ForceLimiter none = new ForceLimiter(0, 1);
    Vec3 force = new Vec3(3, 0, 0);
    none.clamp(force, 1_000_000);
    assertEquals(0, force.length());
    for (double wrong : new double[] {-1, Double.NaN}) {
      refusal(() -> new ForceLimiter(wrong, 1));
      refusal(() -> new ForceLimiter(1, wrong));
    }
    refusal(() -> new ForceLimiter(1, 0));
  }

  @Test
  void aForceOfExactlyTheMaximumStaysAsItIs() {
    ForceLimiter limiter = new ForceLimiter(5, Double.POSITIVE_INFINITY);
    Vec3 force = new Vec3(3, 4, 0);
    limiter.clamp(force, 1_000_000);
    assertTrue(force.sameBits(new Vec3(3, 4, 0)));
    limiter.clamp(force.set(6, 8, 0), 1_000_000);
    assertEquals(3, force.x, 1e-12);
    assertTrue(force.length() <= 5);
    limiter.clamp(force.set(Double.NaN, 0, 0), 1_000_000);
    assertEquals(0, force.length());
    assertEquals(1, limiter.notFinite());
  }
}
