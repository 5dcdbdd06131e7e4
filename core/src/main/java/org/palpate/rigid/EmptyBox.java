package org.palpate.rigid;

import org.palpate.volume.BitCube;

/** Quick proofs that voxels around a point or a short segment are empty, by whole windows. */
final class EmptyBox {
  private static final long[] COLUMNS = {
    0, 0x1111_1111_1111_1111L, 0x3333_3333_3333_3333L, 0x7777_7777_7777_7777L, -1
  };
  private static final long[] ROWS = {
    0, 0x000F_000F_000F_000FL, 0x00FF_00FF_00FF_00FFL, 0x0FFF_0FFF_0FFF_0FFFL, -1
  };
  private static final long[] LAYERS = {0, 0xFFFFL, 0xFFFF_FFFFL, 0xFFFF_FFFF_FFFFL, -1};

  /** Half the edge of a window of 4 voxels, less half a voxel for where the point lies in it. */
  private static final double NEAR = 1.5;

  /** The same for 8 voxels. */
  private static final double FAR = 3.5;

  /** Beyond this, coordinates have no window. */
  private static final double LARGEST = 1 << 30;

  private EmptyBox() {}

  /** Returns half the edge of an empty cube around a point, voxels: 0, 1.5 or 3.5. */
  static double around(BitCube bits, double x, double y, double z) {
    if (!isNear(x) || !isNear(y) || !isNear(z)) {
      return 0;
    }
    int i = (int) Math.floor(x + 0.5) - 2;
    int j = (int) Math.floor(y + 0.5) - 2;
    int k = (int) Math.floor(z + 0.5) - 2;
    if (bits.window(i, j, k) != 0) {
      return 0;
    }
    for (int octant = 0; octant < 8; octant++) {
      int u = i - 2 + 4 * (octant & 1);
      int v = j - 2 + 4 * (octant >> 1 & 1);
      int w = k - 2 + 4 * (octant >> 2);
      if (bits.window(u, v, w) != 0) {
        return NEAR;
      }
    }
    return FAR;
  }

  /** Whether the bounding box of a segment is short and touches no closed solid voxel. */
  static boolean holds(
      BitCube bits, double x0, double y0, double z0, double x1, double y1, double z1) {
    if (!isNear(x0) || !isNear(y0) || !isNear(z0)) {
      return false;
    }
    int i = lowest(x0, x1);
    int j = lowest(y0, y1);
    int k = lowest(z0, z1);
    int sizeX = highest(x0, x1) - i;
    int sizeY = highest(y0, y1) - j;
    int sizeZ = highest(z0, z1) - k;
    return sizeX < 4
        && sizeY < 4
        && sizeZ < 4
        && (bits.window(i, j, k) & COLUMNS[sizeX + 1] & ROWS[sizeY + 1] & LAYERS[sizeZ + 1]) == 0;
  }

  private static boolean isNear(double v) {
    return Math.abs(v) < LARGEST;
  }

  private static int lowest(double a, double b) {
    return (int) Math.ceil(a < b ? a : b) - 1;
  }

  private static int highest(double a, double b) {
    return (int) Math.floor(a > b ? a : b);
  }
}
