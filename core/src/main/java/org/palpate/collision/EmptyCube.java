package org.palpate.collision;

import org.palpate.volume.BitCube;

/**
 * Finds an empty cube around a point, by doubling. A device finds the same one, because it computes
 * with the same bits.
 */
final class EmptyCube {
  /** Half the edge of the smallest cube that is tried, voxels. */
  private static final double SMALLEST = 0.25;

  /** Half the edge of the largest cube, voxels. */
  private static final double LARGEST = 4;

  /** Coordinates beyond it do not fit into an int. */
  private static final double FARTHEST = 0x1p29;

  private static final int WINDOW = 4;

  private EmptyCube() {}

  /** Returns half the edge of the largest closed cube that touches no solid voxel, 0 if none. */
  static double around(BitCube bits, double x, double y, double z) {
    if (!(Math.abs(x) < FARTHEST && Math.abs(y) < FARTHEST && Math.abs(z) < FARTHEST)) {
      return 0;
    }
    double found = 0;
    for (double half = SMALLEST; half <= LARGEST; half *= 2) {
      if (!isEmpty(bits, x, y, z, half)) {
        return found;
      }
      found = half;
    }
    return found;
  }

  private static boolean isEmpty(BitCube bits, double x, double y, double z, double half) {
    int highX = (int) Math.floor(x + half);
    int highY = (int) Math.floor(y + half);
    int highZ = (int) Math.floor(z + half);
    for (int k = lowestCell(z - half); k <= highZ; k += WINDOW) {
      for (int j = lowestCell(y - half); j <= highY; j += WINDOW) {
        for (int i = lowestCell(x - half); i <= highX; i += WINDOW) {
          if ((bits.window(i, j, k) & within(highX - i, highY - j, highZ - k)) != 0) {
            return false;
          }
        }
      }
    }
    return true;
  }

  /** Returns the lowest cell whose closed voxel contains a coordinate. */
  private static int lowestCell(double coordinate) {
    return (int) Math.ceil(coordinate) - 1;
  }

  /** Returns the voxels of a window up to some of its layers, each included. */
  private static long within(int lastX, int lastY, int lastZ) {
    long row = lastX >= WINDOW - 1 ? 0xf : (2L << lastX) - 1;
    long layer = (lastY >= WINDOW - 1 ? 0x1111L : 0x1111L >>> (4 * (WINDOW - 1 - lastY))) * row;
    return lastZ >= WINDOW - 1
        ? layer * 0x0001_0001_0001_0001L
        : layer * (0x0001_0001_0001_0001L >>> (16 * (WINDOW - 1 - lastZ)));
  }
}
