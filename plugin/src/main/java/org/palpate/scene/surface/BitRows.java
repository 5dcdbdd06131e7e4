package org.palpate.scene.surface;

import java.util.Arrays;
import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

/**
 * A box of up to 64 voxels along each axis, cut out of a bit cube; each row along x is one word.
 * Scratch memory of one thread.
 */
final class BitRows {
  static final int MAX_EDGE = Long.SIZE;

  private final long[] rows = new long[MAX_EDGE * MAX_EDGE];
  private int sizeY;
  private int sizeZ;

  /** Fills the rows with the voxels of a box; voxels outside the bit cube are empty. */
  void load(BitCube bits, IntBox voxels) {
    sizeY = voxels.highY - voxels.lowY + 1;
    sizeZ = voxels.highZ - voxels.lowZ + 1;
    Arrays.fill(rows, 0, sizeY * sizeZ, 0);
    for (int bz = voxels.lowZ >> 2; bz <= voxels.highZ >> 2; bz++) {
      for (int by = voxels.lowY >> 2; by <= voxels.highY >> 2; by++) {
        for (int bx = voxels.lowX >> 2; bx <= voxels.highX >> 2; bx++) {
          long word = bits.brick(bx, by, bz);
          if (word != 0) {
            scatter(
                word, (bx << 2) - voxels.lowX, (by << 2) - voxels.lowY, (bz << 2) - voxels.lowZ);
          }
        }
      }
    }
  }

  private void scatter(long word, int x, int y, int z) {
    for (int row = 0; row < 16; row++) {
      long four = (word >>> (4 * row)) & 15;
      int toY = y + (row & 3);
      int toZ = z + (row >> 2);
      if (four != 0 && toY >= 0 && toY < sizeY && toZ >= 0 && toZ < sizeZ) {
        rows[toZ * sizeY + toY] |= x >= 0 ? four << x : four >>> -x;
      }
    }
  }

  /**
   * Returns the cells of a row that have both solid and empty corners. Bit x is the cell between
   * voxels x and x+1; bits from the last voxel on are undefined.
   */
  long mixedCells(int y, int z) {
    long a = row(y, z);
    long b = row(y + 1, z);
    long c = row(y, z + 1);
    long d = row(y + 1, z + 1);
    long any = a | b | c | d;
    long all = a & b & c & d;
    return (any | (any >>> 1)) & ~(all & (all >>> 1));
  }

  /** Returns the corner bits of cell (x,y,z), as {@link CellCaseTable} numbers them. */
  int corners(int x, int y, int z) {
    return (int)
        (two(x, y, z)
            | (two(x, y + 1, z) << 2)
            | (two(x, y, z + 1) << 4)
            | (two(x, y + 1, z + 1) << 6));
  }

  private long two(int x, int y, int z) {
    return (row(y, z) >>> x) & 3;
  }

  private long row(int y, int z) {
    return rows[z * sizeY + y];
  }
}
