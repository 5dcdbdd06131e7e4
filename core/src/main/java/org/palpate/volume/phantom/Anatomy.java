package org.palpate.volume.phantom;

/**
 * What a phantom is made of: some shapes, the region that each combination of them stands for, and
 * the walls, one voxel thick, that part some regions from others.
 *
 * <p>Regions are small numbers of its own; {@link #OPEN} is the outside.
 */
interface Anatomy {
  /** Empty and without walls of its own. */
  int OPEN = 0;

  /** At most 64. */
  Shape[] shapes();

  /** The region of the points that are inside just the shapes whose bits are set. */
  int region(long insideShapes);

  /** The label of all points of a region that is solid through and through, else 0. */
  int label(int region);

  /** Whether the region is hollow and may have walls along its inside. */
  boolean hasWalls(int region);

  /**
   * The label of those points of {@code region} that have, one voxel off along an axis, a point of
   * {@code neighbour}; 0 where there is no wall between the two.
   */
  int wall(int region, int neighbour);

  /** Grey value of solid matter of a label. */
  int greyValue(int label);
}
