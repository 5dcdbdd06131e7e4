package org.palpate.testing;

import java.util.SplittableRandom;

/**
 * Makes coordinates that break naive geometry: integers, halves, their neighbours by one ulp,
 * subnormal and huge numbers, -0.0.
 */
public final class HostileNumbers {
  private HostileNumbers() {}

  /** Returns a coordinate in or about a grid of {@code size} voxels. */
  public static double coordinate(SplittableRandom random, int size) {
    double integer = random.nextInt(-2, size + 3);
    return switch (random.nextInt(10)) {
      case 0, 1 -> integer;
      case 2 -> integer + 0.5;
      case 3 -> Math.nextUp(integer);
      case 4 -> Math.nextDown(integer);
      case 5 -> integer + random.nextInt(-3, 4) * 0x1p-20;
      case 6 -> random.nextInt(4) == 0 ? farAway(random) : integer;
      default -> random.nextDouble(-2, size + 2);
    };
  }

  private static double farAway(SplittableRandom random) {
    return switch (random.nextInt(8)) {
      case 0 -> -0.0;
      case 1 -> Double.MIN_VALUE;
      case 2 -> -Double.MIN_VALUE;
      case 3 -> 1e12;
      case 4 -> -1e12;
      case 5 -> 1e300;
      case 6 -> -1e-300;
      default -> 1e-17;
    };
  }
}
