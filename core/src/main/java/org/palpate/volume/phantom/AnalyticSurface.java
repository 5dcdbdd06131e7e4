package org.palpate.volume.phantom;

import org.palpate.geometry.Vec3;

/**
 * The surface that a phantom's voxels sample, by formula. Immutable; any thread. Costs a square
 * root or two.
 */
public interface AnalyticSurface {
  /**
   * The distance to the surface, voxels; positive where it is empty, negative where it is solid.
   *
   * @param grid in grid coordinates
   */
  double signedDistance(Vec3 grid);

  /**
   * Writes the unit normal at the surface point nearest to {@code grid} into {@code dest}, which
   * may be {@code grid}; it points to where it is empty. Not defined where no single point is
   * nearest.
   */
  Vec3 normal(Vec3 grid, Vec3 dest);
}
