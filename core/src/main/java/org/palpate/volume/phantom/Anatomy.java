package org.palpate.volume.phantom;

/**
 * The composition of a phantom: shapes, the region that each combination of them stands for, and
 * walls of one voxel between some regions.
 *
 * <p>Regions are small numbers that each anatomy chooses; {@link #OPEN} is the outside.
 */
interface Anatomy {
  /** The region that is empty and has no walls. */
  int OPEN = 0;

  /** Returns the shapes, at most 64. */
  Shape[] shapes();

  /** Returns the region of the points that lie in exactly the shapes whose bits are set. */
  int region(long insideShapes);

  /** Returns the label of a region that is solid throughout, else 0. */
  int label(int region);

  /** Whether the region is hollow and may have walls along its inside. */
  boolean hasWalls(int region);

  /**
   * Returns the label of the wall that {@code region} has along {@code neighbour}; 0 if there is
   * none. A point belongs to the wall if a point of the neighbour lies one voxel away along an
   * axis.
   */
  int wall(int region, int neighbour);

  /** Returns the grey value of the solid matter of a label. */
  int greyValue(int label);
}
