package org.palpate.volume.phantom;

/**
 * One body.
 *
 * @param shape its outside
 * @param filling what is inside it
 */
record SimpleAnatomy(Shape shape, Filling filling) implements Anatomy {
  private static final int INSIDE = 1;
  private static final int CORE = 2;
  private static final long CORE_BIT = 2;
  private static final double SHELL_VOXELS = 1.0;

  /** What is inside. */
  enum Filling {
    /** Matter all through. */
    SOLID,
    /** Nothing but a wall of whole voxels along the inside: the thinnest that is closed. */
    VOXEL_WALL,
    /** Nothing but a shell one voxel thick, wherever it lies. */
    SHELL
  }

  @Override
  public Shape[] shapes() {
    return filling == Filling.SHELL
        ? new Shape[] {shape, shape.shrunk(SHELL_VOXELS)}
        : new Shape[] {shape};
  }

  @Override
  public int region(long insideShapes) {
    return insideShapes == 0 ? OPEN : (insideShapes & CORE_BIT) == 0 ? INSIDE : CORE;
  }

  @Override
  public int label(int region) {
    return region == INSIDE && filling != Filling.VOXEL_WALL ? 1 : 0;
  }

  @Override
  public boolean hasWalls(int region) {
    return region == INSIDE && filling == Filling.VOXEL_WALL;
  }

  @Override
  public int wall(int region, int neighbour) {
    return neighbour == OPEN ? 1 : 0;
  }

  @Override
  public int greyValue(int label) {
    return label == 0 ? 0 : Phantom.SOLID_GREY;
  }
}
