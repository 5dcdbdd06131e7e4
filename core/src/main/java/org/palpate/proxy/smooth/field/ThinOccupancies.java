package org.palpate.proxy.smooth.field;

import org.palpate.collision.CollisionScene;

/**
 * The occupancies of thin slices, which are cut from voxels by what the grey values say. A voxel
 * that is partly solid is filled from the side of its solid neighbour along the long axis, as far
 * as its occupancy goes. If the neighbours on both sides are alike, it is filled evenly.
 *
 * <p>Occupancies are whole numbers from 0 to {@link GreyOccupancyCache#WHOLE}, a byte each. Cost:
 * 512 cells for each window.
 */
final class ThinOccupancies {
  /** The least number of cells for each voxel at which a window's voxels fit into one reading. */
  static final double MIN_PER_VOXEL = 1.6;

  private static final int EDGE = GreyOccupancyCache.EDGE;
  private static final int WHOLE = GreyOccupancyCache.WHOLE;
  private static final int BYTE = 0xFF;

  private final ThinGrid grid;
  private final GreyOccupancyCache cache;

  /** The occupancies of voxels, as the cache reads them. */
  private final long[] voxels = new long[EDGE * EDGE];

  /** One column of these along the long axis. */
  private final int[] column = new int[EDGE];

  /** The voxel of a column that holds the lower end of each cell. */
  private final int[] lowVoxel = new int[EDGE];

  /** The fraction of that voxel below the cell. */
  private final double[] below = new double[EDGE];

  /** Creates the cells of a grid that has at least {@link #MIN_PER_VOXEL} for each voxel. */
  ThinOccupancies(ThinGrid grid, GreyOccupancyCache cache) {
    this.grid = grid;
    this.cache = cache;
  }

  /** Writes the occupancies of the 8x8x8 cells from (x,y,z) on, as {@link GreyOccupancyCache}. */
  void read(CollisionScene scene, int x, int y, int z, long[] dest) {
    int firstCell = grid.axis() == 0 ? x : grid.axis() == 1 ? y : z;
    int firstVoxel = SeedCell.floor(firstCell / grid.perVoxel()) - 1;
    for (int n = 0; n < EDGE; n++) {
      double at = (firstCell + n) / grid.perVoxel() - firstVoxel;
      lowVoxel[n] = (int) at;
      below[n] = at - lowVoxel[n];
    }
    switch (grid.axis()) {
      case 0 -> cache.read(scene, firstVoxel, y, z, voxels);
      case 1 -> cache.read(scene, x, firstVoxel, z, voxels);
      default -> cache.read(scene, x, y, firstVoxel, voxels);
    }
    for (int row = 0; row < EDGE * EDGE; row++) {
      dest[row] = 0;
    }
    for (int n = 0; n < EDGE * EDGE; n++) {
      cutColumn(n & (EDGE - 1), n >> 3, dest);
    }
  }

  /** Cuts one column into cells; (a,b) are its coordinates along the two other axes. */
  private void cutColumn(int a, int b, long[] dest) {
    int lowest = WHOLE;
    int highest = 0;
    for (int n = 0; n < EDGE; n++) {
      column[n] = (int) (voxels[rowOf(a, b, n)] >>> shiftOf(a, n)) & BYTE;
      lowest = Math.min(lowest, column[n]);
      highest = Math.max(highest, column[n]);
    }
    if (highest == 0) {
      return;
    }
    for (int n = 0; n < EDGE; n++) {
      int occupancy = lowest == WHOLE ? WHOLE : cell(n);
      dest[rowOf(a, b, n)] |= (long) occupancy << shiftOf(a, n);
    }
  }

  private int rowOf(int a, int b, int n) {
    return grid.axis() == 0 ? EDGE * b + a : grid.axis() == 1 ? EDGE * b + n : EDGE * n + b;
  }

  private int shiftOf(int a, int n) {
    return 8 * (grid.axis() == 0 ? n : a);
  }

  /** Returns the occupancy of a cell, which lies in one voxel or in two. */
  private int cell(int n) {
    int voxel = lowVoxel[n];
    double from = below[n];
    double height = 1 / grid.perVoxel();
    double inLower = Math.min(height, 1 - from);
    double solid = inLower * part(voxel, from, inLower);
    if (inLower < height) {
      solid += (height - inLower) * part(voxel + 1, 0, height - inLower);
    }
    return (int) (solid * grid.perVoxel() + 0.5);
  }

  /**
   * Returns the occupancy of a part of a voxel.
   *
   * @param from the lower end of the part, as a fraction of the voxel
   * @param height its height, as a fraction of the voxel
   */
  private double part(int voxel, double from, double height) {
    int whole = column[voxel];
    if (whole == 0 || whole == WHOLE) {
      return whole;
    }
    int lower = column[voxel - 1];
    int upper = column[voxel + 1];
    double start = lower > upper ? from : 1 - from - height;
    double filled = Math.max(0, Math.min(WHOLE, (whole - WHOLE * start) / height));
    double directed = Math.abs(lower - upper) / (double) WHOLE;
    return whole + directed * (filled - whole);
  }
}
