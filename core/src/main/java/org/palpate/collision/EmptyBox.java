package org.palpate.collision;

import org.palpate.volume.BitCube;

/** Tests quickly, by windows, whether the voxels around a point or a short segment are empty. */
public final class EmptyBox {
  private static final long[] COLUMNS = {
    0, 0x1111_1111_1111_1111L, 0x3333_3333_3333_3333L, 0x7777_7777_7777_7777L, -1
  };
  private static final long[] ROWS = {
    0, 0x000F_000F_000F_000FL, 0x00FF_00FF_00FF_00FFL, 0x0FFF_0FFF_0FFF_0FFFL, -1
  };
  private static final long[] LAYERS = {0, 0xFFFFL, 0xFFFF_FFFFL, 0xFFFF_FFFF_FFFFL, -1};

  /** The 2x2x2 voxels in the middle of a window. */
  private static final long MIDDLE = 0x0000_0660_0660_0000L;

  /**
   * The growth of the empty cube around a point if the 8 windows around its window are empty too.
   */
  private static final double GAIN_OF_NEIGHBOURS = 2;

  /** Coordinates beyond this have no window. */
  private static final double LARGEST = 1 << 30;

  private EmptyBox() {}

  /**
   * Returns half the edge of an empty cube around a point, voxels: 0, or from 0.5 to 4 as far as
   * the windows around the point prove.
   */
  public static double around(BitCube bits, double x, double y, double z) {
    if (!isNear(x, y, z)) {
      return 0;
    }
    int i = (int) Math.floor(x + 0.5) - 2;
    int j = (int) Math.floor(y + 0.5) - 2;
    int k = (int) Math.floor(z + 0.5) - 2;
    long window = bits.window(i, j, k);
    if ((window & MIDDLE) != 0) {
      return 0;
    }
    double offX = Math.abs(x - (i + 2));
    double offY = Math.abs(y - (j + 2));
    double offZ = Math.abs(z - (k + 2));
    double off = Math.max(offX, Math.max(offY, offZ));
    if (window != 0) {
      return 1 - off;
    }
    return 2 - off + (areNeighboursEmpty(bits, i, j, k) ? GAIN_OF_NEIGHBOURS : 0);
  }

  private static boolean areNeighboursEmpty(BitCube bits, int i, int j, int k) {
    for (int octant = 0; octant < 8; octant++) {
      int u = i - 2 + 4 * (octant & 1);
      int v = j - 2 + 4 * (octant >> 1 & 1);
      int w = k - 2 + 4 * (octant >> 2);
      if (bits.window(u, v, w) != 0) {
        return false;
      }
    }
    return true;
  }

  /** Whether the bounding box of a segment is short and touches no closed solid voxel. */
  public static boolean holds(
      BitCube bits, double x0, double y0, double z0, double x1, double y1, double z1) {
    if (!isNear(x0, y0, z0) || !isNear(x1, y1, z1)) {
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

  private static boolean isNear(double x, double y, double z) {
    return Math.abs(x) < LARGEST && Math.abs(y) < LARGEST && Math.abs(z) < LARGEST;
  }

  private static int lowest(double a, double b) {
    return (int) Math.ceil(a < b ? a : b) - 1;
  }

  private static int highest(double a, double b) {
    return (int) Math.floor(a > b ? a : b);
  }
}
