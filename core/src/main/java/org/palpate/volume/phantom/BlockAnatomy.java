package org.palpate.volume.phantom;

import org.palpate.geometry.Vec3;

/** A cuboid on a slab. Their faces lie between voxels if the edge is a multiple of 16. */
final class BlockAnatomy implements Anatomy {
  static final int BLOCK = 1;
  static final int BASE = 2;

  private static final long BLOCK_BIT = 1;

  private final Shape[] shapes;

  /** Creates the block of a cube with this edge, voxels. */
  BlockAnatomy(int edge) {
    double unit = edge / 16.0;
    Shape block =
        Shape.box(
            new Vec3(3 * unit, 3 * unit, 3 * unit), new Vec3(13 * unit, 13 * unit, 11 * unit));
    Shape base = Shape.box(new Vec3(unit, unit, unit), new Vec3(15 * unit, 15 * unit, 3 * unit));
    shapes = new Shape[] {block, base};
  }

  @Override
  public Shape[] shapes() {
    return shapes.clone();
  }

  @Override
  public int region(long insideShapes) {
    if (insideShapes == 0) {
      return OPEN;
    }
    return (insideShapes & BLOCK_BIT) == 0 ? BASE : BLOCK;
  }

  @Override
  public int label(int region) {
    return region;
  }

  @Override
  public boolean hasWalls(int region) {
    return false;
  }

  @Override
  public int wall(int region, int neighbour) {
    return 0;
  }

  @Override
  public int greyValue(int label) {
    return label == 0 ? 0 : Phantom.SOLID_GREY;
  }
}
