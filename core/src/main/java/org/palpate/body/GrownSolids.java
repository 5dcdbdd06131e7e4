package org.palpate.body;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/**
 * The solids of a body, grown by a distance. The points of a tool must avoid them so that the tool
 * keeps a clearance.
 *
 * <p>The grown solids are made of smaller voxels, the "cells". The number of cells along the edge
 * of a voxel is a power of two for each axis, so that positions scale exactly. Invariant: a cell is
 * solid exactly if its distance from some solid voxel of the body is less than the growth. A point
 * that touches no solid cell is therefore at least that far from every voxel. The grid of the cells
 * begins {@link #padVoxels} before that of the body, so that nothing is cut off at its rim.
 *
 * <p>Belongs to one thread.
 */
public final class GrownSolids {
  /** The largest number of cells along the edge of a voxel. */
  public static final int LARGEST_PARTS = 8;

  /** The largest growth, shortest voxel edges. */
  public static final double MOST_GROWTH_EDGES = 64;

  private final BitCube bits;
  private final int partsX;
  private final int partsY;
  private final int partsZ;
  private final double growthMm;
  private final int pad;
  private final int reachX;
  private final int reachY;
  private final int reachZ;
  private final double cellX;
  private final double cellY;
  private final double cellZ;
  private final BitCube cells;
  private final IntBox region = new IntBox();

  /**
   * Grows all solids of a cube that the caller keeps.
   *
   * @param growthMm the distance, mm, positive
   * @param longestCellMm edges of cells are at most this long, mm, as far as {@link #LARGEST_PARTS}
   *     cells to a voxel allow
   */
  public GrownSolids(BitCube bits, GridMetric metric, double growthMm, double longestCellMm) {
    if (!(growthMm > 0) || growthMm / metric.shortestEdgeMm() > MOST_GROWTH_EDGES) {
      throw new IllegalArgumentException(
          "growth must be positive and at most "
              + MOST_GROWTH_EDGES
              + " voxels: growthMm="
              + growthMm);
    }
    if (!(longestCellMm > 0)) {
      throw new IllegalArgumentException("cells must have an edge: longestCellMm=" + longestCellMm);
    }
    this.bits = bits;
    this.growthMm = growthMm;
    partsX = parts(metric.spacingX(), longestCellMm);
    partsY = parts(metric.spacingY(), longestCellMm);
    partsZ = parts(metric.spacingZ(), longestCellMm);
    cellX = metric.spacingX() / partsX;
    cellY = metric.spacingY() / partsY;
    cellZ = metric.spacingZ() / partsZ;
    reachX = (int) Math.ceil(growthMm / cellX);
    reachY = (int) Math.ceil(growthMm / cellY);
    reachZ = (int) Math.ceil(growthMm / cellZ);
    pad = Math.max(pad(reachX, partsX), Math.max(pad(reachY, partsY), pad(reachZ, partsZ)));
    cells =
        new BitCube(
            (bits.sizeX() + 2 * pad) * partsX,
            (bits.sizeY() + 2 * pad) * partsY,
            (bits.sizeZ() + 2 * pad) * partsZ);
    update(bits.bounds());
  }

  /**
   * Returns the memory that grown solids with these settings take, bytes; may exceed the free
   * memory.
   */
  public static double bytesFor(
      BitCube bits, GridMetric metric, double growthMm, double longestCellMm) {
    int partsX = parts(metric.spacingX(), longestCellMm);
    int partsY = parts(metric.spacingY(), longestCellMm);
    int partsZ = parts(metric.spacingZ(), longestCellMm);
    double pad = 2 * (growthMm / metric.shortestEdgeMm() + 1);
    double voxels = (bits.sizeX() + pad) * (bits.sizeY() + pad) * (bits.sizeZ() + pad);
    return voxels * partsX * partsY * partsZ / 8;
  }

  private static int parts(double edgeMm, double longestCellMm) {
    int parts = 1;
    while (parts < LARGEST_PARTS && edgeMm / parts > longestCellMm) {
      parts *= 2;
    }
    return parts;
  }

  private static int pad(int reach, int parts) {
    return (reach + parts - 1) / parts;
  }

  /** Returns the grown solids; each voxel of this cube is a cell. */
  public BitCube cells() {
    return cells;
  }

  /** Returns the number of cells along the edge of a voxel, for an axis: 0 is x. */
  public int parts(int axis) {
    return axis == 0 ? partsX : axis == 1 ? partsY : partsZ;
  }

  /** Returns the edge of a cell along an axis, mm: 0 is x. */
  public double cellMm(int axis) {
    return axis == 0 ? cellX : axis == 1 ? cellY : cellZ;
  }

  /** Returns the number of voxels by which the grid of the cells begins before the body's grid. */
  public int padVoxels() {
    return pad;
  }

  /** Returns the growth, mm. */
  public double growthMm() {
    return growthMm;
  }

  /**
   * Returns the length by which a grown voxel reaches beyond the voxel along a direction, mm. This
   * is the support function of the growth.
   *
   * @param normal unit, along the axes of the grid in mm
   */
  public double reachMm(Vec3 normal) {
    double weightX = Math.abs(normal.x) * cellX;
    double weightY = Math.abs(normal.y) * cellY;
    double weightZ = Math.abs(normal.z) * cellZ;
    double most = 0;
    for (int c = 0; c < reachZ; c++) {
      for (int b = 0; b < reachY; b++) {
        double left = growthMm * growthMm - cellZ * cellZ * c * c - cellY * cellY * b * b;
        if (left > 0) {
          int a = (int) Math.ceil(Math.sqrt(left) / cellX) - 1;
          most = Math.max(most, weightX * (a + 1) + weightY * (b + 1) + weightZ * (c + 1));
        }
      }
    }
    return most;
  }

  /** Converts a coordinate from the body's grid to the grid of the cells, along an axis: 0 is x. */
  public double toCells(double voxels, int axis) {
    return (voxels + pad) * parts(axis);
  }

  /**
   * Restores the invariant after voxels in a box were added or removed.
   *
   * @return the box of cells that may have changed; owned by this, overwritten by the next call
   */
  public IntBox update(IntBox changed) {
    region.clear();
    if (changed.isEmpty()) {
      return region;
    }
    region.include(
        Math.max(0, firstCell(changed.lowX, partsX) - reachX),
        Math.max(0, firstCell(changed.lowY, partsY) - reachY),
        Math.max(0, firstCell(changed.lowZ, partsZ) - reachZ));
    region.include(
        Math.min(cells.sizeX() - 1, firstCell(changed.highX + 1, partsX) - 1 + reachX),
        Math.min(cells.sizeY() - 1, firstCell(changed.highY + 1, partsY) - 1 + reachY),
        Math.min(cells.sizeZ() - 1, firstCell(changed.highZ + 1, partsZ) - 1 + reachZ));
    clearRegion();
    growIntoRegion();
    return region;
  }

  private int firstCell(int voxel, int parts) {
    return (voxel + pad) * parts;
  }

  private void clearRegion() {
    for (int k = region.lowZ; k <= region.highZ; k++) {
      for (int j = region.lowY; j <= region.highY; j++) {
        for (int i = region.lowX; i <= region.highX; i++) {
          if ((i & 3) == 0 && cells.brick(i >> 2, j >> 2, k >> 2) == 0) {
            i += 3;
          } else {
            cells.clear(i, j, k);
          }
        }
      }
    }
  }

  /** Grows every voxel that can reach the region. */
  private void growIntoRegion() {
    int lowX = Math.max(0, (region.lowX - reachX) / partsX - pad - 1);
    int lowY = Math.max(0, (region.lowY - reachY) / partsY - pad - 1);
    int lowZ = Math.max(0, (region.lowZ - reachZ) / partsZ - pad - 1);
    int highX = Math.min(bits.sizeX() - 1, (region.highX + reachX) / partsX - pad + 1);
    int highY = Math.min(bits.sizeY() - 1, (region.highY + reachY) / partsY - pad + 1);
    int highZ = Math.min(bits.sizeZ() - 1, (region.highZ + reachZ) / partsZ - pad + 1);
    for (int k = lowZ; k <= highZ; k++) {
      for (int j = lowY; j <= highY; j++) {
        for (int i = lowX; i <= highX; i++) {
          if (bits.brick(i >> 2, j >> 2, k >> 2) == 0) {
            i |= 3;
          } else if (bits.get(i, j, k)) {
            growVoxel(i, j, k);
          }
        }
      }
    }
  }

  /**
   * Grows one voxel. An inner voxel adds its own cells alone, because adjacent voxels reach
   * farther.
   */
  private void growVoxel(int i, int j, int k) {
    boolean inner = bits.isSurrounded(i, j, k);
    int aroundX = inner ? 0 : reachX;
    int aroundY = inner ? 0 : reachY;
    int aroundZ = inner ? 0 : reachZ;
    int firstX = firstCell(i, partsX);
    int firstY = firstCell(j, partsY);
    int firstZ = firstCell(k, partsZ);
    int lastX = Math.min(region.highX, firstX + partsX - 1 + aroundX);
    int lastY = Math.min(region.highY, firstY + partsY - 1 + aroundY);
    int lastZ = Math.min(region.highZ, firstZ + partsZ - 1 + aroundZ);
    for (int c = Math.max(region.lowZ, firstZ - aroundZ); c <= lastZ; c++) {
      double gapZ = cellZ * gap(c, firstZ, partsZ);
      for (int b = Math.max(region.lowY, firstY - aroundY); b <= lastY; b++) {
        double gapY = cellY * gap(b, firstY, partsY);
        double left = growthMm * growthMm - gapZ * gapZ - gapY * gapY;
        for (int a = Math.max(region.lowX, firstX - aroundX); a <= lastX; a++) {
          double gapX = cellX * gap(a, firstX, partsX);
          if (gapX * gapX < left) {
            cells.set(a, b, c);
          }
        }
      }
    }
  }

  /** Returns how many cells lie between a cell and a voxel along an axis. */
  private static int gap(int cell, int firstOfVoxel, int parts) {
    return Math.max(0, Math.max(cell - (firstOfVoxel + parts), firstOfVoxel - cell - 1));
  }
}
