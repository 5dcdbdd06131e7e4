package org.palpate.volume.phantom;

/**
 * The anatomy of a single body.
 *
 * @param shape the outside of the body
 * @param filling the inside of the body
 */
record SimpleAnatomy(Shape shape, Filling filling) implements Anatomy {
  private static final int INSIDE = 1;
  private static final int CORE = 2;
  private static final long CORE_BIT = 2;
  private static final double SHELL_VOXELS = 1.0;

  /** The inside of a body. */
  enum Filling {
    /** Solid throughout. */
    SOLID,
    /** Hollow, with a wall of whole voxels along the inside: the thinnest that is closed. */
    VOXEL_WALL,
    /** Hollow, with a shell one voxel thick that does not depend on the grid. */
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
