package org.palpate.scene.surface;

/**
 * The crossings of the surface with the lines between voxel centres. Several threads read them at
 * once.
 */
@FunctionalInterface
public interface EdgeCrossings {
  /** Crossings at the midpoint, for bits alone. */
  EdgeCrossings MIDPOINT = (i, j, k, axis) -> 0.5f;

  /**
   * Returns the position of the surface between the centre of voxel (i,j,k), 0, and the centre of
   * the next one along {@code axis}, 1.
   *
   * <p>The value lies strictly between 0 and 1. Called only if one of the two voxels is solid;
   * either may lie outside the grid.
   */
  float fraction(int i, int j, int k, int axis);
}
