package org.palpate.volume.phantom;

/**
 * Voxelizes an anatomy brick by brick. The centre of a voxel decides its label, and 4x4x4 points in
 * it decide its grey value. A voxel of a wall is solid throughout, in labels and in grey values.
 * Owned scratch: one thread.
 */
final class AnatomyVoxelizer implements BrickSource {
  /** The sign patterns of three surfaces. */
  private static final int MAX_SIGN_PATTERNS = 8;

  /** The octants of a voxel; also the points in an octant. */
  private static final int OCTANTS = 8;

  /** The distance of the outermost points from the voxel centre: 0.375 times the root of 3. */
  private static final double POINTS_RADIUS = 0.6496;

  /** The distance of each point from the centre of its octant: 0.125 times the root of 3. */
  private static final double OCTANT_RADIUS = 0.2166;

  /** The distance of the outermost voxel centre from that of a row of four bricks. */
  private static final double ROW_RADIUS = 7.8;

  /** The distance of the outermost voxel centre from the brick centre: 1.5 times the root of 3. */
  private static final double BRICK_RADIUS = 2.6;

  /** The distance from a voxel centre at which walls look for a neighbouring region. */
  private static final double WALL_REACH = 1;

  private final Anatomy anatomy;
  private final ActiveShapes space;
  private final ActiveShapes row;
  private final ActiveShapes brick;
  private final ActiveShapes voxel;
  private final ActiveShapes cell;
  private final ActiveShapes octant;
  private final int[] greyOfSignPattern = new int[MAX_SIGN_PATTERNS];

  AnatomyVoxelizer(Anatomy anatomy) {
    this.anatomy = anatomy;
    space = new ActiveShapes(anatomy.shapes());
    row = new ActiveShapes(anatomy.shapes());
    brick = new ActiveShapes(anatomy.shapes());
    voxel = new ActiveShapes(anatomy.shapes());
    cell = new ActiveShapes(anatomy.shapes());
    octant = new ActiveShapes(anatomy.shapes());
    space.widen();
  }

  @Override
  public void enterRow(int brickX, int brickY, int brickZ) {
    row.narrow(space, 4 * brickX + 8, 4 * brickY + 2, 4 * brickZ + 2, ROW_RADIUS + WALL_REACH);
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
      return grey(brick.insideShapes(0, 0, 0));
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
    brick.narrow(row, x, y, z, BRICK_RADIUS + WALL_REACH);
    return brick.isUniform();
  }

  private int centreLabel(double x, double y, double z) {
    voxel.narrow(brick, x, y, z, WALL_REACH);
    return voxel.isUniform()
        ? anatomy.label(anatomy.region(voxel.insideShapes(x, y, z)))
        : label(voxel, x, y, z);
  }

  private int grey(int i, int j, int k) {
    double x = i + 0.5;
    double y = j + 0.5;
    double z = k + 0.5;
    voxel.narrow(brick, x, y, z, WALL_REACH);
    int region = anatomy.region(voxel.insideShapes(x, y, z));
    if (voxel.isUniform()) {
      return anatomy.greyValue(anatomy.label(region));
    }
    if (anatomy.hasWalls(region)) {
      int wall = wallLabel(voxel, region, x, y, z);
      if (wall != 0) {
        return anatomy.greyValue(wall);
      }
    }
    cell.narrow(voxel, x, y, z, POINTS_RADIUS);
    return fillGreyOfSignPattern(cell) && isOneGrey(cell)
        ? greyOfSignPattern[0]
        : supersampled(i, j, k);
  }

  /** Returns the mean grey value of the points of a voxel that belongs to no wall. */
  private int supersampled(int i, int j, int k) {
    int sum = 0;
    for (int n = 0; n < OCTANTS; n++) {
      sum += octant(i + (n & 1) * 0.5, j + (n >> 1 & 1) * 0.5, k + (n >> 2) * 0.5);
    }
    return (sum + OCTANTS * OCTANTS / 2) / (OCTANTS * OCTANTS);
  }

  /** Returns the sum of the grey values at the eight points of an octant. */
  private int octant(double x, double y, double z) {
    octant.narrow(cell, x + 0.25, y + 0.25, z + 0.25, OCTANT_RADIUS);
    boolean known = fillGreyOfSignPattern(octant);
    if (known && isOneGrey(octant)) {
      return OCTANTS * greyOfSignPattern[0];
    }
    int sum = 0;
    for (int n = 0; n < OCTANTS; n++) {
      double u = x + 0.125 + (n & 1) * 0.25;
      double v = y + 0.125 + (n >> 1 & 1) * 0.25;
      double w = z + 0.125 + (n >> 2) * 0.25;
      sum +=
          known
              ? greyOfSignPattern[octant.signPattern(u, v, w)]
              : grey(octant.insideShapes(u, v, w));
    }
    return sum;
  }

  /**
   * Sets {@link #greyOfSignPattern}, so that a grey value is looked up once a pattern and not once
   * a point. Returns false if there are too many patterns.
   */
  private boolean fillGreyOfSignPattern(ActiveShapes near) {
    if (near.signPatternCount() > greyOfSignPattern.length) {
      return false;
    }
    for (int n = 0; n < near.signPatternCount(); n++) {
      greyOfSignPattern[n] = grey(near.insideShapesAt(n));
    }
    return true;
  }

  /** Whether all sign patterns have one grey value, as mostly where shapes of one body overlap. */
  private boolean isOneGrey(ActiveShapes near) {
    boolean same = true;
    for (int n = 1; same && n < near.signPatternCount(); n++) {
      same = greyOfSignPattern[n] == greyOfSignPattern[0];
    }
    return same;
  }

  private int grey(long insideShapes) {
    return anatomy.greyValue(anatomy.label(anatomy.region(insideShapes)));
  }

  private int label(ActiveShapes near, double x, double y, double z) {
    int region = anatomy.region(near.insideShapes(x, y, z));
    return anatomy.hasWalls(region) ? wallLabel(near, region, x, y, z) : anatomy.label(region);
  }

  private int wallLabel(ActiveShapes near, int region, double x, double y, double z) {
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

  private int wall(ActiveShapes near, int region, double x, double y, double z) {
    return anatomy.wall(region, anatomy.region(near.insideShapes(x, y, z)));
  }
}
