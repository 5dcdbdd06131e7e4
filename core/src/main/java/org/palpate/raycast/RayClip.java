package org.palpate.raycast;

import org.palpate.geometry.IntBox;

/**
 * The part of a ray that passes near a box of voxels: what lies outside can be skipped. Generous by
 * {@link #MARGIN_VOXELS}, so that rounding never skips a voxel of the box. Owned scratch.
 */
final class RayClip {
  /** Far more than the rounding of positions that a grid can hold. */
  private static final double MARGIN_VOXELS = 2;

  /** Where the part begins, 0 or more. */
  double from;

  /** Where it ends, 1 or less. */
  double to;

  /** Clips; false where no part of the ray passes near the box. */
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
    double towardsLow = (low - start) / delta;
    double towardsHigh = (high - start) / delta;
    from = Math.max(from, Math.min(towardsLow, towardsHigh));
    to = Math.min(to, Math.max(towardsLow, towardsHigh));
    return from <= to;
  }
}
