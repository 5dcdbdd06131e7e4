package org.palpate.proxy.smooth.field;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.IntBox;

/** A source of the B-spline coefficients of an occupancy field, one at each corner of the grid. */
interface CoefficientSource {
  /**
   * Writes the 27 coefficients around corner (x,y,z): the box-filtered occupancy of the voxels near
   * each.
   *
   * @param seed the cell from which empty space is reached
   * @param coefficients receives 27 values of about 0 to 1, x fastest
   * @return false if all are 0; then {@code coefficients} is left as it was
   */
  boolean load(CollisionScene scene, int x, int y, int z, SeedCell seed, double[] coefficients);

  /** Whether the coefficients that were loaded last are the same for this seed cell. */
  boolean holdsFor(SeedCell seed);

  /** Whether the coefficients that were loaded last are surely the same for every seed cell. */
  boolean holdsForEverySeed();

  /** Returns how many columns were interpolated so far between slices, or on terraces. */
  long columns();

  /** Forgets all cached voxels. */
  void forget();

  /**
   * Forgets at least what depends on changed voxels.
   *
   * @param changed the voxels; scratch, whose content is undefined afterwards
   */
  void forget(IntBox changed);

  /** Returns the standard deviation of the smoothing along an axis, in shortest voxel edges. */
  double sigmaEdges(int axis);
}
