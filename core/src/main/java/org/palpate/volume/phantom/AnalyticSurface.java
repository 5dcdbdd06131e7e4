package org.palpate.volume.phantom;

import org.palpate.geometry.Vec3;

/**
 * The surface that the voxels of a phantom sample, by a formula. Immutable; any thread. Cost: one
 * or two square roots.
 */
public interface AnalyticSurface {
  /**
   * {@return the distance to the surface, voxels: positive in empty space, negative in the solid}
   *
   * @param grid a point in grid coordinates
   */
  double signedDistance(Vec3 grid);

  /**
   * Writes the unit normal at the surface point closest to a given point. It points into empty
   * space. Undefined if several points are equally close.
   *
   * @param grid the point, grid coordinates
   * @param dest receives the normal; may be {@code grid}
   * @return {@code dest}
   */
  Vec3 normal(Vec3 grid, Vec3 dest);
}
