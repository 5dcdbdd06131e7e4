package org.palpate.raycast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.testing.ExactOracle;
import org.palpate.testing.HostileNumbers;
import org.palpate.testing.RandomCases;
import org.palpate.testing.Seeds;

class ExactPredicatesTest {
  private final ExactPredicates exact = new ExactPredicates();
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  /** Points on the line up to a few roundings, where only exact arithmetic tells the side. */
  @Test
  void theSideIsThatOfRationalArithmeticWithinAFewRoundingsOfTheLine() {
    int[] sides = new int[3];
    int cases = RandomCases.of(30_000);
    for (int n = 0; n < cases; n++) {
      boolean whole = random.nextBoolean();
      double ax = coordinate(whole);
      double ay = coordinate(whole);
      double bx = coordinate(whole);
      double by = coordinate(whole);
      double t = random.nextInt(-2, 4) / 2.0;
      double cx = aFewRoundingsFrom(ax + t * (bx - ax));
      double cy = aFewRoundingsFrom(ay + t * (by - ay));
      int expected = side(ax, ay, bx, by, cx, cy);
      sides[expected + 1]++;
      String what = "seed=" + Seeds.seed() + " case " + n;
      assertEquals(expected, exact.side(ax, ay, bx, by, cx, cy), what);
    }
    for (int side = -1; side <= 1; side++) {
      assertTrue(sides[side + 1] > cases / 20, "too few on side " + side);
    }
  }

  private double coordinate(boolean whole) {
    return whole ? random.nextInt(-20, 20) : random.nextDouble(-20, 20);
  }

  private double aFewRoundingsFrom(double value) {
    int roundings = random.nextBoolean() ? 0 : random.nextInt(-2, 3);
    return value + roundings * Math.ulp(value);
  }

  private static int side(double ax, double ay, double bx, double by, double cx, double cy) {
    BigDecimal left = minus(cx, ax).multiply(minus(by, ay));
    return left.subtract(minus(cy, ay).multiply(minus(bx, ax))).signum();
  }

  private static BigDecimal minus(double a, double b) {
    return new BigDecimal(a).subtract(new BigDecimal(b));
  }

  @Test
  void aRayTouchesTheVoxelsThatTheOracleSays() {
    int touches = 0;
    int cases = RandomCases.of(20_000);
    for (int n = 0; n < cases; n++) {
      Ray ray = new Ray().from(hostile(), hostile(), hostile()).to(hostile(), hostile(), hostile());
      int i = random.nextInt(-1, 5);
      int j = random.nextInt(-1, 5);
      int k = random.nextInt(-1, 5);
      boolean expected = ExactOracle.touches(ray, i, j, k);
      touches += expected ? 1 : 0;
      String what = "seed=" + Seeds.seed() + " case " + n + " " + ray;
      assertEquals(expected, exact.touchesVoxel(ray, i, j, k), what);
    }
    assertTrue(touches > cases / 100, "too few touch: " + touches);
  }

  /** A cube of 4 voxels is touched if one of its 64 voxels is. */
  @Test
  void aRayTouchesACubeIfItTouchesAVoxelOfIt() {
    int touches = 0;
    int cases = RandomCases.of(5000);
    for (int n = 0; n < cases; n++) {
      Ray ray = new Ray().from(hostile(), hostile(), hostile()).to(hostile(), hostile(), hostile());
      boolean expected = false;
      for (int voxel = 0; voxel < 64; voxel++) {
        expected |= ExactOracle.touches(ray, voxel % 4, voxel / 4 % 4 + 1, voxel / 16);
      }
      touches += expected ? 1 : 0;
      String what = "seed=" + Seeds.seed() + " case " + n + " " + ray;
      assertEquals(expected, exact.touchesBox(ray, 0, 1, 0, 4), what);
    }
    assertTrue(touches > cases / 20, "too few touch: " + touches);
  }

  private double hostile() {
    return HostileNumbers.coordinate(random, 5);
  }
}
