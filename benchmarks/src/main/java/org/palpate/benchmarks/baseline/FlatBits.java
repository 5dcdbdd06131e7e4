package org.palpate.benchmarks.baseline;

import org.palpate.volume.BitCube;

/** A flat bit array, x fastest, as plain code would use; voxels outside are empty. */
final class FlatBits {
  private final int sizeX;
  private final int sizeY;
  private final int sizeZ;
  private final long[] bits;

  /** Copies the voxels. */
  FlatBits(BitCube cube) {
    sizeX = cube.sizeX();
    sizeY = cube.sizeY();
    sizeZ = cube.sizeZ();
    bits = new long[(int) (((long) sizeX * sizeY * sizeZ + 63) / 64)];
    for (int k = 0; k < sizeZ; k++) {
      for (int j = 0; j < sizeY; j++) {
        for (int i = 0; i < sizeX; i++) {
          if (cube.get(i, j, k)) {
            int index = (k * sizeY + j) * sizeX + i;
            bits[index >> 6] |= 1L << index;
          }
        }
      }
    }
  }

  /** Whether a voxel is solid. */
  boolean solid(int i, int j, int k) {
    if (i < 0 || i >= sizeX || j < 0 || j >= sizeY || k < 0 || k >= sizeZ) {
      return false;
    }
    int index = (k * sizeY + j) * sizeX + i;
    return (bits[index >> 6] >>> index & 1) != 0;
  }

  /** Whether the voxel at a position is solid. */
  boolean solidAt(double x, double y, double z) {
    return solid((int) Math.floor(x), (int) Math.floor(y), (int) Math.floor(z));
  }
}
