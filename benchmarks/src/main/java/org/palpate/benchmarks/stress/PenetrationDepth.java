package org.palpate.benchmarks.stress;

import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/**
 * Computes the distance from a point in a solid to the nearest empty voxel by testing all voxels.
 */
final class PenetrationDepth {
  private PenetrationDepth() {}

  /** Returns the depth in voxels; 0 outside solids. */
  static double voxels(BitCube bits, Vec3 point) {
    int i = (int) Math.floor(point.x);
    int j = (int) Math.floor(point.y);
    int k = (int) Math.floor(point.z);
    if (!bits.get(i, j, k)) {
      return 0;
    }
    double least = Double.POSITIVE_INFINITY;
    for (int z = -1; z <= bits.sizeZ(); z++) {
      for (int y = -1; y <= bits.sizeY(); y++) {
        for (int x = -1; x <= bits.sizeX(); x++) {
          if (!bits.get(x, y, z)) {
            least = Math.min(least, squared(point, x, y, z));
          }
        }
      }
    }
    return Math.sqrt(least);
  }

  private static double squared(Vec3 point, int x, int y, int z) {
    double u = outside(point.x, x);
    double v = outside(point.y, y);
    double w = outside(point.z, z);
    return u * u + v * v + w * w;
  }

  private static double outside(double at, int cell) {
    return Math.max(0, Math.max(cell - at, at - cell - 1));
  }
}
