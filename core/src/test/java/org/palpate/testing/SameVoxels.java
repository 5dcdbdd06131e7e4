package org.palpate.testing;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.palpate.volume.BitCube;

/** Requires that two cubes of the same sizes have the same voxels, and the same block words. */
public final class SameVoxels {
  private SameVoxels() {}

  /**
   * Fails unless all words are equal.
   *
   * @param where what is compared, for the message
   */
  public static void require(BitCube expected, BitCube actual, String where) {
    assertEquals(expected.solidCount(), actual.solidCount(), where);
    for (int z = 0; z < expected.bricksZ(); z++) {
      for (int y = 0; y < expected.bricksY(); y++) {
        for (int x = 0; x < expected.bricksX(); x++) {
          assertEquals(expected.brick(x, y, z), actual.brick(x, y, z), where);
          assertEquals(
              expected.block(x / 4, y / 4, z / 4), actual.block(x / 4, y / 4, z / 4), where);
        }
      }
    }
  }
}
