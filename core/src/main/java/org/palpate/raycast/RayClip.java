package org.palpate.raycast;

import org.palpate.geometry.IntBox;

/**
 * Clips a ray to a box of voxels. The clipped part is longer than the exact one by {@link
 * #MARGIN_VOXELS}, so that rounding never removes a voxel of the box. Owned scratch.
 */
final class RayClip {
  /** Far more than the rounding of a position within a grid. */
  private static final double MARGIN_VOXELS = 2;

  /** The ray parameter at which the clipped part begins, 0 or more. */
  double from;

  /** The ray parameter at which the clipped part ends, 1 or less. */
  double to;

  /** Clips the ray and returns whether any part of it passes near the box. */
  boolean clip(Ray ray, IntBox box) {
    from = 0;
    to = 1;
    return !box.isEmpty()
        && clipAxis(ray.fromX, ray.toX, box.lowX, box.highX)
        && clipAxis(ray.fromY, ray.toY, box.lowY, box.highY)
        && clipAxis(ray.fromZ, ray.toZ, box.lowZ, box.highZ);
  }

  private boolean clipAxis(double start, double end, int lowVoxel, int highVoxel) {
    double low = lowVoxel - MARGIN_VOXELS;
    double high = highVoxel + 1 + MARGIN_VOXELS;
    double delta = end - start;
    if (delta == 0) {
      return start >= low && start <= high;
    }
    double tLow = (low - start) / delta;
    double tHigh = (high - start) / delta;
    from = Math.max(from, Math.min(tLow, tHigh));
    to = Math.min(to, Math.max(tLow, tHigh));
    return from <= to;
  }
}
