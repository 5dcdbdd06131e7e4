package org.palpate.raycast;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import org.palpate.volume.BitCube;

/** Random cubes and rays; many rays lie on grid planes, along axes or outside. */
final class RandomRays {
  private static final int SIZE = 20;
  private static final int SOLIDS = 60;

  private RandomRays() {}

  static BitCube sparseCube(SplittableRandom random) {
    BitCube bits = new BitCube(SIZE, SIZE - 3, SIZE + 5);
    for (int n = 0; n < SOLIDS; n++) {
      bits.set(random.nextInt(SIZE), random.nextInt(SIZE - 3), random.nextInt(SIZE + 5));
    }
    return bits;
  }

  static void next(SplittableRandom random, Ray ray) {
    ray.from(coordinate(random), coordinate(random), coordinate(random));
    ray.to(coordinate(random), coordinate(random), coordinate(random));
    switch (random.nextInt(6)) {
      case 0 -> ray.toX = ray.fromX;
      case 1 -> {
        ray.toY = ray.fromY;
        ray.toZ = ray.fromZ;
      }
      case 2 -> ray.to(ray.fromX + step(random), ray.fromY + step(random), ray.fromZ);
      default -> {}
    }
  }

  private static double step(SplittableRandom random) {
    return random.nextDouble() * 3 - 1.5;
  }

  private static double coordinate(SplittableRandom random) {
    double anywhere = random.nextDouble() * (SIZE + 10) - 5;
    return switch (random.nextInt(4)) {
      case 0 -> Math.floor(anywhere);
      case 1 -> Math.floor(anywhere) + 0.5;
      default -> anywhere;
    };
  }

  static void assertSame(RayHit expected, RayHit hit, String what) {
    assertEquals(expected.t, hit.t, what);
    assertEquals(expected.i, hit.i, what);
    assertEquals(expected.j, hit.j, what);
    assertEquals(expected.k, hit.k, what);
    assertEquals(expected.axis, hit.axis, what);
  }
}
