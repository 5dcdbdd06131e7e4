package org.palpate.raycast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.statistics.SkipCounters;
import org.palpate.statistics.SkipKind;
import org.palpate.testing.ExactOracle;
import org.palpate.testing.RandomCases;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

/** Rays that come from far away, and rays that only graze the bounds of all solids. */
class ExactRayCasterReachTest {
  private final ExactRayCaster caster = new ExactRayCaster();
  private final RayHit hit = new RayHit();

  /**
   * The ray passes the edge at x = 4, y = 4 of the only solid, and lies outside of the solid before
   * and after. Its coordinates are whole multiples of 2^-20, so that no rounding moves it.
   */
  @Test
  void aRayThatOnlyTouchesAnEdgeOfTheOnlySolidHits() {
    long seed = Seeds.seed();
    SplittableRandom random = new SplittableRandom(seed);
    BitCube bits = new BitCube(8, 8, 8);
    bits.set(4, 4, 4);
    for (int n = 0; n < RandomCases.of(20_000); n++) {
      int before = random.nextInt(1, 40);
      int after = random.nextInt(1, 40);
      double right = random.nextInt(1, 1 << 20) * 0x1p-20;
      double down = random.nextInt(1, 1 << 20) * 0x1p-20;
      double along = random.nextInt(-(1 << 20), 1 << 20) * 0x1p-20;
      double height = 4.5;
      double[] from = {4 - before * right, 4 + before * down, height - before * along};
      double[] to = {4 + after * right, 4 - after * down, height + after * along};
      int axis = random.nextInt(3);
      boolean back = random.nextBoolean();
      Ray ray = back ? TurnedRay.of(axis, to, from) : TurnedRay.of(axis, from, to);
      assertTrue(caster.cast(bits, ray, hit), () -> "seed=" + seed + " " + ray);
      double t = (double) (back ? after : before) / (before + after);
      assertEquals(t, hit.t, 1e-13, () -> "seed=" + seed + " " + ray);
      from[1] -= 0x1p-40; // a hair below the edge
      to[1] -= 0x1p-40;
      Ray below = TurnedRay.of(axis, from, to);
      assertFalse(caster.cast(bits, below, hit), () -> "seed=" + seed + " " + below);
    }
  }

  @Test
  void raysFromFarAwayAgreeWithTheExactOracle() {
    long seed = Seeds.seed();
    SplittableRandom random = new SplittableRandom(seed);
    BitCube bits = new BitCube(16, 16, 16);
    for (int n = 0; n < 30; n++) {
      bits.set(random.nextInt(16), random.nextInt(16), random.nextInt(16));
    }
    int hits = 0;
    int rays = RandomCases.of(2_000);
    for (int n = 0; n < rays; n++) {
      double far = Math.scalb(1.0, random.nextInt(10, 45));
      double[] from = new double[3];
      double[] to = new double[3];
      for (int axis = 0; axis < 3; axis++) {
        from[axis] = random.nextDouble(-far, far);
        to[axis] = random.nextDouble(-1, 17);
      }
      Ray ray = random.nextBoolean() ? TurnedRay.of(0, from, to) : TurnedRay.of(0, to, from);
      String what = "seed=" + seed + " " + ray;
      double expected = ExactOracle.firstTouch(bits, ray);
      boolean found = caster.cast(bits, ray, hit);
      assertEquals(!Double.isNaN(expected), found, what);
      if (found) {
        hits++;
        assertEquals(expected, hit.t, 1e-13, what);
        assertTrue(bits.get(hit.i, hit.j, hit.k), what);
        assertTrue(ExactOracle.touches(ray, hit.i, hit.j, hit.k), what);
      }
    }
    assertTrue(hits > 0.01 * rays, "too few hits to mean anything: " + hits);
  }

  /** At 2^44 a position in doubles is off by up to 1/256 voxel, which decides near edges. */
  @Test
  void raysFromVeryFarAwayAgreeWithTheExhaustiveCasterInADenseScene() {
    long seed = Seeds.seed();
    SplittableRandom random = new SplittableRandom(seed);
    ExhaustiveRayCaster exhaustive = new ExhaustiveRayCaster(new ExactPredicates());
    RayHit expected = new RayHit();
    BitCube bits = new BitCube(16, 16, 16);
    for (int n = 0; n < 16 * 16 * 16; n++) {
      if (random.nextInt(3) == 0) {
        bits.set(n % 16, n / 16 % 16, n / 256);
      }
    }
    double far = 0x1p44;
    for (int n = 0; n < RandomCases.of(60_000); n++) {
      double[] from = new double[3];
      double[] to = new double[3];
      for (int axis = 0; axis < 3; axis++) {
        from[axis] = random.nextDouble(-far, far);
        to[axis] = random.nextDouble(-1, 17);
      }
      Ray ray = TurnedRay.of(0, from, to);
      String what = "seed=" + seed + " " + ray;
      boolean found = caster.cast(bits, ray, hit);
      assertEquals(exhaustive.cast(bits, ray, expected), found, what);
      if (found) {
        assertEquals(expected.t, hit.t, 1e-13, what);
        assertTrue(new ExactPredicates().touchesVoxel(ray, hit.i, hit.j, hit.k), what);
      }
    }
  }

  /** The difference of the two ends is greater than the largest double. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void aRayWhoseLengthOverflowsHits(int axis) {
    BitCube bits = new BitCube(8, 8, 8);
    bits.set(4, 4, 4);
    double[] from = {-1.5e308, 4.5, 4.5};
    double[] to = {1.2e308, 4.5, 4.5};
    assertTrue(caster.cast(bits, TurnedRay.of(axis, from, to), hit));
    assertEquals(1.5 / 2.7, hit.t, 1e-15);
    assertEquals(axis, hit.axis);
    assertTrue(caster.cast(bits, TurnedRay.of(axis, to, from), hit));
    assertEquals(1.2 / 2.7, hit.t, 1e-15);
    bits.clear(4, 4, 4);
    bits.set(4, 5, 3);
    assertFalse(caster.cast(bits, TurnedRay.of(axis, from, to), hit));
  }

  /** The ray runs within a plane, so that the traversal with exact ties takes it. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void aRayFromFarAwayEntersTheBoundsAtOnce(int axis) {
    BitCube bits = new BitCube(32, 32, 32);
    bits.set(1, 1, 1);
    bits.set(30, 30, 30);
    double[] from = {-100_000.5, 20, 11.5};
    double[] to = {200_000.5, 20, 12.5};
    assertFalse(caster.cast(bits, TurnedRay.of(axis, from, to), hit));
    SkipCounters counts = new SkipCounters();
    caster.addSkips(counts);
    long bricks = counts.of(SkipKind.EMPTY_BRICKS);
    assertTrue(bricks > 0 && bricks < 50, "bricks=" + bricks);
  }
}
