package org.palpate.body;

import java.util.Optional;
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
  private final Optional<GrowthStencil> stencil;
  private final IntBox region = new IntBox();

  /**
   * Grows all solids of a cube that the caller keeps.
   *
   * @param bits the solids of the body; after an edit, call {@link #update}
   * @param metric the edges of a voxel
   * @param growthMm the distance, mm, positive
   * @param longestCellMm edges of cells are at most this long, mm, as far as {@link #LARGEST_PARTS}
   *     cells to a voxel allow
   * @throws IllegalArgumentException if the growth is not positive or too large, or cells have no
   *     edge
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
    growAll();
    stencil = GrowthStencil.of(this);
  }

  /**
   * {@return the memory that grown solids with these settings take, bytes; may exceed the free
   * memory}
   *
   * @param bits the solids of the body
   * @param metric the edges of a voxel
   * @param growthMm the distance, mm, positive
   * @param longestCellMm edges of cells are at most this long, mm
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

  /**
   * Adds to a cube the voxels that are nearer to solid voxels than a distance, and the solid voxels
   * themselves.
   *
   * @param solids solid voxels
   * @param metric the edges of a voxel
   * @param marginMm the distance, mm; at least 0
   * @param dest a cube of the same size
   */
  public static void addNear(BitCube solids, GridMetric metric, double marginMm, BitCube dest) {
    if (marginMm == 0) {
      addTo(dest, solids, 0);
      return;
    }
    GrownSolids grown = new GrownSolids(solids, metric, marginMm, Double.POSITIVE_INFINITY);
    addTo(dest, grown.cells(), grown.padVoxels());
  }

  private static void addTo(BitCube dest, BitCube source, int pad) {
    for (int k = 0; k < dest.sizeZ(); k++) {
      for (int j = 0; j < dest.sizeY(); j++) {
        for (int i = 0; i < dest.sizeX(); i++) {
          if (source.get(i + pad, j + pad, k + pad)) {
            dest.set(i, j, k);
          }
        }
      }
    }
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

  /** {@return the grown solids; each voxel of this cube is a cell} */
  public BitCube cells() {
    return cells;
  }

  /**
   * {@return the number of cells along the edge of a voxel, for an axis}
   *
   * @param axis 0 for x, 1 for y, 2 for z
   */
  public int parts(int axis) {
    return axis == 0 ? partsX : axis == 1 ? partsY : partsZ;
  }

  /**
   * {@return the edge of a cell along an axis, mm}
   *
   * @param axis 0 for x, 1 for y, 2 for z
   */
  public double cellMm(int axis) {
    return axis == 0 ? cellX : axis == 1 ? cellY : cellZ;
  }

  /** {@return the number of voxels by which the grid of the cells begins before the body's grid} */
  public int padVoxels() {
    return pad;
  }

  /** {@return the growth, mm} */
  public double growthMm() {
    return growthMm;
  }

  /**
   * {@return the length by which a grown voxel reaches beyond the voxel along a direction, mm} This
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

  /**
   * {@return a coordinate of the body's grid in the grid of the cells}
   *
   * @param voxels the coordinate in the body's grid
   * @param axis 0 for x, 1 for y, 2 for z
   */
  public double toCells(double voxels, int axis) {
    return (voxels + pad) * parts(axis);
  }

  /**
   * Restores the invariant after voxels in a box were added or removed.
   *
   * @param changed the box of voxels, perhaps empty
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
    for (int c = region.lowZ; c <= region.highZ; c++) {
      for (int b = region.lowY; b <= region.highY; b++) {
        for (int a = region.lowX; a <= region.highX; a++) {
          updateCell(a, b, c);
        }
      }
    }
    return region;
  }

  private int firstCell(int voxel, int parts) {
    return (voxel + pad) * parts;
  }

  private void updateCell(int a, int b, int c) {
    if (isNearSolid(a, b, c)) {
      cells.set(a, b, c);
    } else {
      cells.clear(a, b, c);
    }
  }

  /** Whether a cell is nearer to some solid voxel than the growth. */
  private boolean isNearSolid(int a, int b, int c) {
    return stencil.isPresent()
        ? stencil.get().isNearSolid(bits, a, b, c)
        : isNearSolidOneByOne(a, b, c);
  }

  /** The same, where a stencil is too large. */
  private boolean isNearSolidOneByOne(int a, int b, int c) {
    int highZ = Math.min(bits.sizeZ() - 1, highestVoxel(c, 2));
    for (int k = Math.max(0, lowestVoxel(c, 2)); k <= highZ; k++) {
      int highY = Math.min(bits.sizeY() - 1, highestVoxel(b, 1));
      for (int j = Math.max(0, lowestVoxel(b, 1)); j <= highY; j++) {
        int highX = Math.min(bits.sizeX() - 1, highestVoxel(a, 0));
        for (int i = Math.max(0, lowestVoxel(a, 0)); i <= highX; i++) {
          if (bits.brick(i >> 2, j >> 2, k >> 2) == 0) {
            i |= 3;
          } else if (bits.get(i, j, k) && reaches(i, j, k, a, b, c)) {
            return true;
          }
        }
      }
    }
    return false;
  }

  /**
   * {@return the lowest voxel, along an axis, that may be nearer to a cell than the growth; it may
   * lie outside the grid}
   *
   * @param cell the number of the cell along the axis
   * @param axis 0 for x, 1 for y, 2 for z
   */
  public int lowestVoxel(int cell, int axis) {
    return Math.floorDiv(cell - reach(axis), parts(axis)) - pad;
  }

  /**
   * {@return the highest voxel, along an axis, that may be nearer to a cell than the growth; it may
   * lie outside the grid}
   *
   * @param cell the number of the cell along the axis
   * @param axis 0 for x, 1 for y, 2 for z
   */
  public int highestVoxel(int cell, int axis) {
    return Math.floorDiv(cell + reach(axis), parts(axis)) - pad;
  }

  private int reach(int axis) {
    return axis == 0 ? reachX : axis == 1 ? reachY : reachZ;
  }

  /**
   * {@return whether a voxel is nearer to a cell than the growth, so that it makes the cell solid}
   *
   * @param i the voxel's number along x
   * @param j its number along y
   * @param k its number along z
   * @param a the cell's number along x
   * @param b its number along y
   * @param c its number along z
   */
  public boolean reaches(int i, int j, int k, int a, int b, int c) {
    double gapX = cellX * gap(a, firstCell(i, partsX), partsX);
    return gapX * gapX < leftSquare(b, firstCell(j, partsY), c, firstCell(k, partsZ));
  }

  /** Returns the square of the growth that y and z leave for x, mm^2. */
  private double leftSquare(int b, int firstY, int c, int firstZ) {
    double gapY = cellY * gap(b, firstY, partsY);
    double gapZ = cellZ * gap(c, firstZ, partsZ);
    return growthMm * growthMm - gapZ * gapZ - gapY * gapY;
  }

  private void growAll() {
    IntBox solid = bits.bounds();
    for (int k = solid.lowZ; k <= solid.highZ; k++) {
      for (int j = solid.lowY; j <= solid.highY; j++) {
        for (int i = solid.lowX; i <= solid.highX; i++) {
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
    int lastX = Math.min(cells.sizeX(), firstX + partsX + aroundX) - 1;
    int lastY = Math.min(cells.sizeY(), firstY + partsY + aroundY) - 1;
    int lastZ = Math.min(cells.sizeZ(), firstZ + partsZ + aroundZ) - 1;
    for (int c = Math.max(0, firstZ - aroundZ); c <= lastZ; c++) {
      for (int b = Math.max(0, firstY - aroundY); b <= lastY; b++) {
        double left = leftSquare(b, firstY, c, firstZ);
        for (int a = Math.max(0, firstX - aroundX); a <= lastX; a++) {
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
