package org.palpate.collision;

import org.palpate.volume.BitCube;

/** Tests quickly, by a window, whether the voxels around a short segment are empty. */
public final class EmptyBox {
  private static final long[] COLUMNS = {
    0, 0x1111_1111_1111_1111L, 0x3333_3333_3333_3333L, 0x7777_7777_7777_7777L, -1
  };
  private static final long[] ROWS = {
    0, 0x000F_000F_000F_000FL, 0x00FF_00FF_00FF_00FFL, 0x0FFF_0FFF_0FFF_0FFFL, -1
  };
  private static final long[] LAYERS = {0, 0xFFFFL, 0xFFFF_FFFFL, 0xFFFF_FFFF_FFFFL, -1};

  private EmptyBox() {}

  /**
   * {@return whether the bounding box of a segment is short and touches no closed solid voxel}
   *
   * @param bits the voxels
   * @param x0 one end of the segment along x, grid coordinates
   * @param y0 its y component
   * @param z0 its z component
   * @param x1 the other end along x
   * @param y1 its y component
   * @param z1 its z component
   */
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
    return BitCube.hasWindow(x) && BitCube.hasWindow(y) && BitCube.hasWindow(z);
  }

  private static int lowest(double a, double b) {
    return (int) Math.ceil(a < b ? a : b) - 1;
  }

  private static int highest(double a, double b) {
    return (int) Math.floor(a > b ? a : b);
  }
}
