package org.palpate.fracture.fit;

import java.util.Arrays;
import java.util.List;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * The surface of a fragment at rest in cubic cells. Each cell near the surface knows the surface
 * point nearest to its centre, so that a look-up costs one load. One thread an instance.
 */
final class SurfaceCells {
  /** The distance from the surface up to which cells know a point, cells. */
  private static final int REACH_CELLS = 5;

  private static final int FAR = -1;
  private static final int DEEP = -2;

  private final List<Vec3> points;
  private final List<Vec3> normals;
  private final double cellMm;
  private final Vec3 low = new Vec3();
  private final int sizeX;
  private final int sizeY;
  private final int sizeZ;
  private final int[] nearest;
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
    this.cellMm = cellMm;
    low.set(points.get(0));
    Vec3 high = new Vec3().set(points.get(0));
    for (Vec3 p : points) {
      low.set(Math.min(low.x, p.x), Math.min(low.y, p.y), Math.min(low.z, p.z));
      high.set(Math.max(high.x, p.x), Math.max(high.y, p.y), Math.max(high.z, p.z));
    }
    double marginMm = (REACH_CELLS + 1) * cellMm;
    low.set(low.x - marginMm, low.y - marginMm, low.z - marginMm);
    sizeX = (int) ((high.x + marginMm - low.x) / cellMm) + 1;
    sizeY = (int) ((high.y + marginMm - low.y) / cellMm) + 1;
    sizeZ = (int) ((high.z + marginMm - low.z) / cellMm) + 1;
    nearest = new int[Math.multiplyExact(Math.multiplyExact(sizeX, sizeY), sizeZ)];
    spread();
    markInside(bits, grid);
  }

  /** Gives each cell near the surface the index of the nearest point. */
  private void spread() {
    Arrays.fill(nearest, FAR);
    for (int n = 0; n < points.size(); n++) {
      int i = cell(points.get(n).x, low.x);
      int j = cell(points.get(n).y, low.y);
      int k = cell(points.get(n).z, low.z);
      for (int w = k - REACH_CELLS; w <= k + REACH_CELLS; w++) {
        for (int v = j - REACH_CELLS; v <= j + REACH_CELLS; v++) {
          for (int u = i - REACH_CELLS; u <= i + REACH_CELLS; u++) {
            int index = index(u, v, w);
            int other = nearest[index];
            if (other < 0 || square(n, u, v, w) < square(other, u, v, w)) {
              nearest[index] = n;
            }
          }
        }
      }
    }
  }

  private int index(int i, int j, int k) {
    return (k * sizeY + j) * sizeX + i;
  }

  /** Returns the squared distance of a point from the centre of a cell. */
  private double square(int n, int i, int j, int k) {
    Vec3 p = points.get(n);
    double x = low.x + (i + 0.5) * cellMm - p.x;
    double y = low.y + (j + 0.5) * cellMm - p.y;
    double z = low.z + (k + 0.5) * cellMm - p.z;
    return x * x + y * y + z * z;
  }

  private void markInside(BitCube bits, VoxelGrid grid) {
    Vec3 centre = new Vec3();
    for (int k = 0; k < sizeZ; k++) {
      for (int j = 0; j < sizeY; j++) {
        for (int i = 0; i < sizeX; i++) {
          if (nearest[index(i, j, k)] == FAR) {
            centre.set(i + 0.5, j + 0.5, k + 0.5).mul(cellMm, centre).add(low, centre);
            grid.worldToGrid(centre, centre);
            boolean isInside =
                bits.get(
                    (int) Math.floor(centre.x),
                    (int) Math.floor(centre.y),
                    (int) Math.floor(centre.z));
            nearest[index(i, j, k)] = isInside ? DEEP : FAR;
          }
        }
      }
    }
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
    if (i < 0 || j < 0 || k < 0 || i >= sizeX || j >= sizeY || k >= sizeZ) {
      return Place.FAR;
    }
    int index = nearest[index(i, j, k)];
    if (index < 0) {
      return index == DEEP ? Place.DEEP : Place.FAR;
    }
    found = index;
    Vec3 p = points.get(found);
    Vec3 n = normals.get(found);
    heightMm = (x - p.x) * n.x + (y - p.y) * n.y + (z - p.z) * n.z;
    return Place.NEAR;
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
