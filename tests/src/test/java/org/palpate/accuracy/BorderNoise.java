package org.palpate.accuracy;

import java.util.SplittableRandom;
import org.palpate.volume.BitCube;

/** Makes noise at the border of solids. */
final class BorderNoise {
  private static final int[][] NEIGHBOURS = {
    {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}
  };

  private BorderNoise() {}

  /** Returns a copy in which a fraction of the voxels at the border is inverted. */
  static BitCube flipped(BitCube bits, double fraction, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    BitCube noisy = bits.copy();
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          if (isBorder(bits, i, j, k) && random.nextDouble() < fraction) {
            flip(noisy, i, j, k);
          }
        }
      }
    }
    return noisy;
  }

  private static boolean isBorder(BitCube bits, int i, int j, int k) {
    for (int[] n : NEIGHBOURS) {
      if (bits.get(i, j, k) != bits.get(i + n[0], j + n[1], k + n[2])) {
        return true;
      }
    }
    return false;
  }

  private static void flip(BitCube bits, int i, int j, int k) {
    if (bits.get(i, j, k)) {
      bits.clear(i, j, k);
    } else {
      bits.set(i, j, k);
    }
  }
}
