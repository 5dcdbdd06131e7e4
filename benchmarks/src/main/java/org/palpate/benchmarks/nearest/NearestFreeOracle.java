package org.palpate.benchmarks.nearest;

import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/**
 * A naive oracle of the distance from a device to the nearest free point. It tests every empty
 * voxel of the grid and of a rim of one voxel around it, whether or not a path leads there. Unit
 * voxels.
 */
final class NearestFreeOracle {
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
          if (!bits.get(i, j, k)) {
            double x = clamp(device.x, i);
            double y = clamp(device.y, j);
            double z = clamp(device.z, k);
            double square = square(device, x, y, z);
            if (square < least && square(from, x, y, z) <= radius * radius) {
              least = square;
            }
          }
        }
      }
    }
    return Math.sqrt(least);
  }

  /** Returns the coordinate within a voxel that is nearest to {@code at}. */
  private static double clamp(double at, int cell) {
    return Math.max(cell, Math.min(cell + 1.0, at));
  }

  private static double square(Vec3 from, double x, double y, double z) {
    return (x - from.x) * (x - from.x) + (y - from.y) * (y - from.y) + (z - from.z) * (z - from.z);
  }
}
