package org.palpate.proxy.smooth.field;

import org.palpate.collision.CollisionScene;

/** Where the smoothed field gets its values at the corners of voxels from. */
public interface CoefficientSource {
  /**
   * Writes the smoothed share of solid at the 27 corners around corner (x,y,z), x fastest.
   *
   * @param seedX cell from which empty space is reached, as are y and z
   * @param nodes 27 shares between 0 and 1
   * @return false where all are 0, and {@code nodes} was left as it was
   */
  boolean load(
      CollisionScene obstacles,
      int x,
      int y,
      int z,
      int seedX,
      int seedY,
      int seedZ,
      double[] nodes);

  /** Whether the nodes that were loaded last hold for this seed too. */
  boolean holdsFor(int seedX, int seedY, int seedZ);

  /** Forgets what is kept of the solids. */
  void forget();

  /** The standard deviation of the smoothing along an axis, in shortest voxel edges. */
  double sigmaEdges(int axis);
}
