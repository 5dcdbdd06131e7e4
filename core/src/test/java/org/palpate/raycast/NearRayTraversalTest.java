package org.palpate.raycast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.testing.RandomCases;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class NearRayTraversalTest {
  private final EmptySpaceSkipper empty = new EmptySpaceSkipper(true);
  private final RayHit hit = new RayHit();

  /** Rays whose numbers are random come near a tie very rarely. */
  @Test
  void decidesRandomRaysAsTheExhaustiveCasterDoes() {
    long seed = Seeds.seed();
    SplittableRandom random = new SplittableRandom(seed);
    DecidedRays both =
        new DecidedRays(
            RandomRays.sparseCube(random),
            (cube, ray, dest) -> NearRayTraversal.cast(cube, ray, empty, dest));
    both.assertSame(RandomCases.of(20_000), 0.99, 0.02, () -> randomRay(random), "seed=" + seed);
  }

  private static Ray randomRay(SplittableRandom random) {
    double x = random.nextDouble(-2, 22);
    double y = random.nextDouble(-2, 19);
    double z = random.nextDouble(-2, 27);
    double length = random.nextBoolean() ? 2 : 10;
    return new Ray()
        .from(x, y, z)
        .to(
            x + random.nextDouble(-length, length),
            y + random.nextDouble(-length, length),
            z + random.nextDouble(-length, length));
  }

  /** All rays between two voxels of the brick from 4 to 7, with one solid voxel in it. */
  @Test
  void aRayEndsAtOnceExactlyIfNoSolidLiesInTheBoxOfItsCells() {
    for (int solid = 0; solid < 64; solid++) {
      BitCube bits = new BitCube(12, 12, 12);
      bits.set(4 + (solid & 3), 4 + (solid >> 2 & 3), 4 + (solid >> 4));
      for (int pair = 0; pair < 64 * 64; pair++) {
        int from = pair & 63;
        int to = pair >> 6;
        if (from != solid) {
          long before = empty.skippedBricks;
          NearRayTraversal.cast(bits, between(from, to), empty, hit);
          assertEquals(
              isInBox(from, to, solid) ? 0 : 1,
              empty.skippedBricks - before,
              "from voxel " + from + " to " + to + ", solid " + solid);
        }
      }
    }
  }

  private static Ray between(int from, int to) {
    return new Ray()
        .from(4.2 + (from & 3), 4.3 + (from >> 2 & 3), 4.4 + (from >> 4))
        .to(4.6 + (to & 3), 4.7 + (to >> 2 & 3), 4.8 + (to >> 4));
  }

  private static boolean isInBox(int one, int other, int voxel) {
    return isBetween(one & 3, other & 3, voxel & 3)
        && isBetween(one >> 2 & 3, other >> 2 & 3, voxel >> 2 & 3)
        && isBetween(one >> 4, other >> 4, voxel >> 4);
  }

  private static boolean isBetween(int one, int other, int layer) {
    return Math.min(one, other) <= layer && layer <= Math.max(one, other);
  }

  @Test
  void theMedianIsTheSecondOfThreeCrossingsInAnyOrder() {
    double[][] orders = {{1, 2, 3}, {1, 3, 2}, {2, 1, 3}, {2, 3, 1}, {3, 1, 2}, {3, 2, 1}};
    for (double[] order : orders) {
      assertEquals(2, NearRayTraversal.median(order[0], order[1], order[2]));
    }
    assertEquals(1, NearRayTraversal.median(1, 1, Double.POSITIVE_INFINITY));
  }

  @Test
  void aCrossingIsInDoubtNearTheNextOneOrNearTheEnd() {
    assertFalse(NearRayTraversal.isInDoubt(0.5, 0.75));
    assertTrue(NearRayTraversal.isInDoubt(0.5, 0.5));
    assertTrue(NearRayTraversal.isInDoubt(0.5, 0.5 + 0x1p-50));
    assertFalse(NearRayTraversal.isInDoubt(0.5, 0.5 + 0x1p-46));
    assertTrue(NearRayTraversal.isInDoubt(1 - 0x1p-50, 2));
    assertFalse(NearRayTraversal.isInDoubt(1 - 0x1p-46, 2));
  }
}
