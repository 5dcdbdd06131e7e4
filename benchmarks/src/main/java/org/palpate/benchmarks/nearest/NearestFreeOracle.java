package org.palpate.benchmarks.nearest;

import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/**
 * A naive oracle of the distance from a device to the nearest free point. It tests every empty
 * voxel of the grid and of a rim of one voxel around it, whether or not a path leads there. Unit
 * voxels.
 */
final class NearestFreeOracle {
  /** Halvings of a segment after which its end is exact to rounding. */
  private static final int HALVINGS = 60;

  private final BitCube bits;

  NearestFreeOracle(BitCube bits) {
    this.bits = bits;
  }

  /** Returns the distance from the device to the nearest free point. */
  double distance(Vec3 device) {
    return distance(device, device, Double.POSITIVE_INFINITY);
  }

  /** Returns the distance to the nearest free point within {@code radius} of {@code from}. */
  double distance(Vec3 device, Vec3 from, double radius) {
    double least = Double.POSITIVE_INFINITY;
    for (int k = -1; k <= bits.sizeZ(); k++) {
      for (int j = -1; j <= bits.sizeY(); j++) {
        for (int i = -1; i <= bits.sizeX(); i++) {
          if (!bits.get(i, j, k) && squareOfNearest(device, from, 0, device, i, j, k) < least) {
            least = Math.min(least, square(device, from, radius, i, j, k));
          }
        }
      }
    }
    return Math.sqrt(least);
  }

  /**
   * Returns the squared distance from the device to the nearest point of a voxel within {@code
   * radius} of {@code from}; infinity if there is none. By Lagrange's condition, that point is the
   * voxel's nearest to some point between the device and {@code from}: to the first that leads into
   * the ball.
   */
  private static double square(Vec3 device, Vec3 from, double radius, int i, int j, int k) {
    if (squareOfNearest(device, from, 1, from, i, j, k) > radius * radius) {
      return Double.POSITIVE_INFINITY;
    }
    double outside = 0;
    double inside = squareOfNearest(device, from, 0, from, i, j, k) <= radius * radius ? 0 : 1;
    for (int n = 0; n < HALVINGS && inside > outside; n++) {
      double middle = (inside + outside) / 2;
      if (squareOfNearest(device, from, middle, from, i, j, k) <= radius * radius) {
        inside = middle;
      } else {
        outside = middle;
      }
    }
    return squareOfNearest(device, from, inside, device, i, j, k);
  }

  /** Returns the squared distance of {@code to} from the voxel's point nearest to a segment's. */
  private static double squareOfNearest(
      Vec3 device, Vec3 from, double part, Vec3 to, int i, int j, int k) {
    double x = clamp(device.x + part * (from.x - device.x), i) - to.x;
    double y = clamp(device.y + part * (from.y - device.y), j) - to.y;
    double z = clamp(device.z + part * (from.z - device.z), k) - to.z;
    return x * x + y * y + z * z;
  }

  /** Returns the coordinate within a voxel that is nearest to {@code at}. */
  private static double clamp(double at, int cell) {
    return Math.max(cell, Math.min(cell + 1.0, at));
  }
}
