package org.palpate.volume.phantom;

import org.palpate.geometry.Vec3;

/**
 * The surface that the voxels of a phantom sample, by a formula. Immutable; any thread. Cost: one
 * or two square roots.
 */
public interface AnalyticSurface {
  /**
   * Returns the distance to the surface, voxels: positive in empty space, negative in the solid.
   *
   * @param grid a point in grid coordinates
   */
  double signedDistance(Vec3 grid);

  /**
   * Writes the unit normal at the surface point closest to {@code grid} into {@code dest}, which
   * may be {@code grid}. It points into empty space. Undefined if several points are equally close.
   */
  Vec3 normal(Vec3 grid, Vec3 dest);
}
