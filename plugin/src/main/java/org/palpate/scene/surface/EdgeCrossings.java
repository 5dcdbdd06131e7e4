package org.palpate.scene.surface;

/** Where between a solid and an empty voxel the surface runs. Read by several threads at once. */
@FunctionalInterface
public interface EdgeCrossings {
  /** Half way: all that bits say. */
  EdgeCrossings MIDPOINT = (i, j, k, axis) -> 0.5f;

  /**
   * How far along from the centre of voxel (i,j,k) to the centre of the next one along {@code axis}
   * the surface runs, strictly between 0 and 1. Asked only where one of the two is solid; either
   * may lie outside the grid.
   */
  float fraction(int i, int j, int k, int axis);
}
