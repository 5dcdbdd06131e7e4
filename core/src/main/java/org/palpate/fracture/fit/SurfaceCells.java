package org.palpate.fracture.fit;

import java.util.Arrays;
import java.util.List;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * The surface of a fragment at rest in cubic cells. Each cell less than five cells from the surface
 * knows the surface point nearest to its centre, so that a look-up costs two loads. Only bricks of
 * cells that are near the surface are stored, so nearly all memory grows with the surface. A
 * reference for each 512 cells grows with the box of the fragment. One thread an instance.
 */
final class SurfaceCells {
  /** The distance from the surface up to which cells know a point, cells. */
  private static final int REACH_CELLS = 5;

  private static final int FAR = -1;

  /** Cells along an edge of a brick, as a power of two. */
  private static final int BRICK_BITS = 3;

  private static final int IN_BRICK = (1 << BRICK_BITS) - 1;
  private static final int CELLS_OF_BRICK = 1 << (3 * BRICK_BITS);

  private final List<Vec3> points;
  private final List<Vec3> normals;
  private final BitCube bits;
  private final VoxelGrid grid;
  private final double cellMm;
  private final Vec3 low = new Vec3();
  private final int bricksX;
  private final int bricksY;
  private final int bricksZ;

  /** The nearest point of each cell of each brick; null for a brick with no point near. */
  private final int[][] bricks;

  private final Vec3 voxel = new Vec3();
  private double heightMm;
  private int found;

  /** The place of a point relative to the surface. */
  enum Place {
    /** Outside, with no surface point near. */
    FAR,

    /** Near the surface; the height above it is known. */
    NEAR,

    /** Inside, with no surface point near. */
    DEEP
  }

  /**
   * Fills the cells.
   *
   * @param surface the surface, with at least one point
   * @param bits the voxels of the fragment
   * @param grid the grid of these voxels
   * @param cellMm the edge of a cell, mm
   */
  SurfaceCells(FragmentSurface surface, BitCube bits, VoxelGrid grid, double cellMm) {
    points = surface.points();
    normals = surface.normals();
    this.bits = bits;
    this.grid = grid;
    this.cellMm = cellMm;
    low.set(points.get(0));
    Vec3 high = new Vec3().set(points.get(0));
    for (Vec3 p : points) {
      low.set(Math.min(low.x, p.x), Math.min(low.y, p.y), Math.min(low.z, p.z));
      high.set(Math.max(high.x, p.x), Math.max(high.y, p.y), Math.max(high.z, p.z));
    }
    double marginMm = (REACH_CELLS + 1) * cellMm;
    low.set(low.x - marginMm, low.y - marginMm, low.z - marginMm);
    bricksX = (cell(high.x + marginMm, low.x) >> BRICK_BITS) + 1;
    bricksY = (cell(high.y + marginMm, low.y) >> BRICK_BITS) + 1;
    bricksZ = (cell(high.z + marginMm, low.z) >> BRICK_BITS) + 1;
    bricks = new int[Math.multiplyExact(Math.multiplyExact(bricksX, bricksY), bricksZ)][];
    spread();
  }

  /** Gives each cell near the surface the index of the nearest point. */
  private void spread() {
    for (int n = 0; n < points.size(); n++) {
      int i = cell(points.get(n).x, low.x);
      int j = cell(points.get(n).y, low.y);
      int k = cell(points.get(n).z, low.z);
      for (int w = k - REACH_CELLS; w <= k + REACH_CELLS; w++) {
        for (int v = j - REACH_CELLS; v <= j + REACH_CELLS; v++) {
          for (int u = i - REACH_CELLS; u <= i + REACH_CELLS; u++) {
            int[] cells = storedBrick(u, v, w);
            int at = inBrick(u, v, w);
            if (cells[at] == FAR || square(n, u, v, w) < square(cells[at], u, v, w)) {
              cells[at] = n;
            }
          }
        }
      }
    }
  }

  private int[] storedBrick(int i, int j, int k) {
    int brick = brick(i, j, k);
    if (bricks[brick] == null) {
      bricks[brick] = new int[CELLS_OF_BRICK];
      Arrays.fill(bricks[brick], FAR);
    }
    return bricks[brick];
  }

  private int brick(int i, int j, int k) {
    return ((k >> BRICK_BITS) * bricksY + (j >> BRICK_BITS)) * bricksX + (i >> BRICK_BITS);
  }

  private static int inBrick(int i, int j, int k) {
    int slice = ((k & IN_BRICK) << BRICK_BITS) + (j & IN_BRICK);
    return (slice << BRICK_BITS) + (i & IN_BRICK);
  }

  /** Returns the squared distance of a point from the centre of a cell. */
  private double square(int n, int i, int j, int k) {
    Vec3 p = points.get(n);
    double x = low.x + (i + 0.5) * cellMm - p.x;
    double y = low.y + (j + 0.5) * cellMm - p.y;
    double z = low.z + (k + 0.5) * cellMm - p.z;
    return x * x + y * y + z * z;
  }

  /** Returns the number of cells that are stored. */
  long storedCells() {
    return CELLS_OF_BRICK * Arrays.stream(bricks).filter(brick -> brick != null).count();
  }

  private int cell(double at, double from) {
    return (int) Math.floor((at - from) / cellMm);
  }

  /**
   * Finds the place of a point. If it is {@link Place#NEAR}, height, nearest point and normal are
   * set.
   *
   * @param x the point along x, world mm, for the fragment at rest
   * @param y its y component
   * @param z its z component
   * @return the place
   */
  Place place(double x, double y, double z) {
    int i = cell(x, low.x);
    int j = cell(y, low.y);
    int k = cell(z, low.z);
    if (i < 0 || j < 0 || k < 0) {
      return Place.FAR;
    }
    if (i >> BRICK_BITS >= bricksX || j >> BRICK_BITS >= bricksY || k >> BRICK_BITS >= bricksZ) {
      return Place.FAR;
    }
    int[] cells = bricks[brick(i, j, k)];
    int index = cells == null ? FAR : cells[inBrick(i, j, k)];
    if (index == FAR) {
      return isInside(x, y, z) ? Place.DEEP : Place.FAR;
    }
    found = index;
    Vec3 p = points.get(found);
    Vec3 n = normals.get(found);
    heightMm = (x - p.x) * n.x + (y - p.y) * n.y + (z - p.z) * n.z;
    return Place.NEAR;
  }

  private boolean isInside(double x, double y, double z) {
    grid.worldToGrid(voxel.set(x, y, z), voxel);
    return bits.get(
        (int) Math.floor(voxel.x), (int) Math.floor(voxel.y), (int) Math.floor(voxel.z));
  }

  /** Returns the height above the tangent plane of the nearest point, mm; negative inside. */
  double heightMm() {
    return heightMm;
  }

  /** Returns the nearest point; not to be written. */
  Vec3 point() {
    return points.get(found);
  }

  /** Returns the outward normal at the nearest point; not to be written. */
  Vec3 normal() {
    return normals.get(found);
  }
}
