package org.palpate.volume.phantom;

/**
 * Decides brick by brick what is where: labels by the centre of each voxel, grey values by 4x4x4
 * points in it, except for walls, which are whole voxels in both. Owned scratch: one thread.
 */
final class Painter implements Bricks {
  private static final int SUBDIVISIONS = 4;
  private static final int SAMPLES = SUBDIVISIONS * SUBDIVISIONS * SUBDIVISIONS;

  /** From the centre of a row of four bricks to the farthest voxel centre: (7.5, 1.5, 1.5). */
  private static final double ROW_RADIUS = 7.8;

  /** From the centre of a brick to the farthest voxel centre: 1.5 times the root of 3. */
  private static final double BRICK_RADIUS = 2.6;

  /** From the centre of a voxel to its corner. */
  private static final double VOXEL_RADIUS = 0.8661;

  private final Anatomy anatomy;
  private final Locality space;
  private final Locality row;
  private final Locality brick;
  private final Locality voxel;

  Painter(Anatomy anatomy) {
    this.anatomy = anatomy;
    space = new Locality(anatomy.shapes());
    row = new Locality(anatomy.shapes());
    brick = new Locality(anatomy.shapes());
    voxel = new Locality(anatomy.shapes());
    space.widen();
  }

  @Override
  public void enterRow(int brickX, int brickY, int brickZ) {
    row.narrow(space, 4 * brickX + 8, 4 * brickY + 2, 4 * brickZ + 2, ROW_RADIUS + VOXEL_RADIUS);
  }

  @Override
  public int labels(int brickX, int brickY, int brickZ, int[] dest) {
    if (enterBrick(brickX, brickY, brickZ)) {
      return anatomy.label(anatomy.region(brick.insideShapes(0, 0, 0)));
    }
    for (int bit = 0; bit < 64; bit++) {
      dest[bit] =
          centreLabel(
              4 * brickX + (bit & 3) + 0.5,
              4 * brickY + (bit >> 2 & 3) + 0.5,
              4 * brickZ + (bit >> 4) + 0.5);
    }
    return MIXED;
  }

  @Override
  public int greys(int brickX, int brickY, int brickZ, int[] dest) {
    if (enterBrick(brickX, brickY, brickZ)) {
      return anatomy.greyValue(anatomy.label(anatomy.region(brick.insideShapes(0, 0, 0))));
    }
    for (int bit = 0; bit < 64; bit++) {
      dest[bit] =
          grey(4 * brickX + (bit & 3), 4 * brickY + (bit >> 2 & 3), 4 * brickZ + (bit >> 4));
    }
    return MIXED;
  }

  private boolean enterBrick(int brickX, int brickY, int brickZ) {
    double x = 4 * brickX + 2;
    double y = 4 * brickY + 2;
    double z = 4 * brickZ + 2;
    brick.narrow(row, x, y, z, BRICK_RADIUS + VOXEL_RADIUS);
    return brick.isUniform();
  }

  private int centreLabel(double x, double y, double z) {
    voxel.narrow(brick, x, y, z, 0);
    return voxel.isUniform()
        ? anatomy.label(anatomy.region(voxel.insideShapes(x, y, z)))
        : label(voxel, x, y, z);
  }

  private int grey(int i, int j, int k) {
    double x = i + 0.5;
    double y = j + 0.5;
    double z = k + 0.5;
    voxel.narrow(brick, x, y, z, VOXEL_RADIUS);
    int region = anatomy.region(voxel.insideShapes(x, y, z));
    if (anatomy.hasWalls(region) && !voxel.isUniform()) {
      int wall = wallLabel(voxel, region, x, y, z);
      if (wall != 0) {
        return anatomy.greyValue(wall);
      }
    }
    return voxel.isClear(VOXEL_RADIUS)
        ? anatomy.greyValue(anatomy.label(region))
        : supersampled(i, j, k);
  }

  /** Walls left out: a layer of voxels is not cut in parts. */
  private int supersampled(int i, int j, int k) {
    int sum = 0;
    for (int n = 0; n < SAMPLES; n++) {
      double x = i + ((n & 3) + 0.5) / SUBDIVISIONS;
      double y = j + ((n >> 2 & 3) + 0.5) / SUBDIVISIONS;
      double z = k + ((n >> 4) + 0.5) / SUBDIVISIONS;
      sum += anatomy.greyValue(anatomy.label(anatomy.region(voxel.insideShapes(x, y, z))));
    }
    return (sum + SAMPLES / 2) / SAMPLES;
  }

  private int label(Locality near, double x, double y, double z) {
    int region = anatomy.region(near.insideShapes(x, y, z));
    return anatomy.hasWalls(region) ? wallLabel(near, region, x, y, z) : anatomy.label(region);
  }

  private int wallLabel(Locality near, int region, double x, double y, double z) {
    for (int side = -1; side <= 1; side += 2) {
      int label = wall(near, region, x + side, y, z);
      if (label == 0) {
        label = wall(near, region, x, y + side, z);
      }
      if (label == 0) {
        label = wall(near, region, x, y, z + side);
      }
      if (label != 0) {
        return label;
      }
    }
    return 0;
  }

  private int wall(Locality near, int region, double x, double y, double z) {
    return anatomy.wall(region, anatomy.region(near.insideShapes(x, y, z)));
  }
}
