package org.palpate.elastic.lattice;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;

/**
 * The numbering of the nodes and cells of a lattice, and its place in the grid. Each cell holds the
 * same number of whole voxels along an axis. Axes are 0 for x, 1 for y and 2 for z.
 *
 * <p>Lattice coordinates count cells: the first node is at (0,0,0), and each cell is a unit cube.
 * Immutable but for the place of a {@link WindowLattice}; any thread.
 */
public final class LatticeLayout {
  /** The number of corners of a cell: bit 0 of a corner's index is x, bit 1 is y, bit 2 is z. */
  public static final int CORNERS = 8;

  /** The most cells that share a node with a cell, itself included. */
  static final int MOST_NEIGHBOURS = 27;

  /** The most cells, so that a lattice fits into memory. */
  static final int MOST_CELLS_IN_ALL = 1 << 19;

  /** The most cells along an axis, so that rounding of lattice coordinates stays below 1e-11. */
  static final int MOST_CELLS = 1 << 10;

  private final int[] originVoxel;
  private final int[] voxelsPerCell;
  private final int[] cells;
  private final double[] edgeMm;
  private final int[] cornerOffsets = new int[CORNERS];
  private final int nodesX;
  private final int nodesY;

  LatticeLayout(int[] originVoxel, int[] voxelsPerCell, int[] cells, double[] edgeMm) {
    this.originVoxel = originVoxel;
    this.voxelsPerCell = voxelsPerCell;
    this.cells = cells;
    this.edgeMm = edgeMm;
    nodesX = cells[0] + 1;
    nodesY = cells[1] + 1;
    for (int corner = 0; corner < CORNERS; corner++) {
      cornerOffsets[corner] = node(corner & 1, corner >> 1 & 1, corner >> 2);
    }
  }

  /**
   * Returns a lattice around a box of voxels.
   *
   * @param solids the voxels to cover, not empty
   * @param metric the spacing of the grid
   * @param wantedEdgeMm the edge of a cell, mm; rounded to whole voxels, at least one
   * @param airCells layers of cells around the box
   * @param multiple the number of cells along each axis is a multiple of this
   * @param divisor the number of voxels along an edge is a multiple of this
   * @throws IllegalArgumentException if there would be more than {@link #MOST_CELLS} cells along an
   *     axis, or {@link #MOST_CELLS_IN_ALL}
   */
  static LatticeLayout around(
      IntBox solids,
      GridMetric metric,
      double wantedEdgeMm,
      int airCells,
      int multiple,
      int divisor) {
    int[] low = {solids.lowX, solids.lowY, solids.lowZ};
    int[] high = {solids.highX, solids.highY, solids.highZ};
    double[] spacing = {metric.spacingX(), metric.spacingY(), metric.spacingZ()};
    int[] origin = new int[3];
    int[] voxels = new int[3];
    int[] cells = new int[3];
    double[] edge = new double[3];
    for (int axis = 0; axis < 3; axis++) {
      double wanted = Math.rint(wantedEdgeMm / (divisor * spacing[axis]));
      int most = ceilDiv(high[axis] - low[axis] + 1, divisor);
      voxels[axis] = divisor * (int) Math.max(1, Math.min(wanted, most));
      edge[axis] = voxels[axis] * spacing[axis];
      int covering = ceilDiv(high[axis] - low[axis] + 1, voxels[axis]);
      int needed = covering + 2 * airCells;
      if (needed > MOST_CELLS - multiple) {
        throw new IllegalArgumentException(
            "the lattice has " + needed + " cells along an axis: choose longer cells");
      }
      cells[axis] = ceilDiv(needed, multiple) * multiple;
      origin[axis] = low[axis] - airCells * voxels[axis];
    }
    double all = (double) cells[0] * cells[1] * cells[2];
    if (all > MOST_CELLS_IN_ALL) {
      throw new IllegalArgumentException(
          "the lattice has " + (long) all + " cells, more than " + MOST_CELLS_IN_ALL);
    }
    return new LatticeLayout(origin, voxels, cells, edge);
  }

  /**
   * Returns the layout of a window at the first cells of this lattice.
   *
   * @param size the number of cells of this lattice in the window along each axis
   * @param factor the number of its cells along an edge of this lattice; divides the number of
   *     voxels
   */
  LatticeLayout window(int[] size, int factor) {
    int[] voxels = new int[3];
    int[] inWindow = new int[3];
    double[] edge = new double[3];
    for (int axis = 0; axis < 3; axis++) {
      voxels[axis] = voxelsPerCell[axis] / factor;
      inWindow[axis] = size[axis] * factor;
      edge[axis] = edgeMm[axis] / factor;
    }
    return new LatticeLayout(originVoxel.clone(), voxels, inWindow, edge);
  }

  /** Moves a window, so that it begins at a cell of the lattice that it belongs to. */
  void moveTo(LatticeLayout whole, int[] firstCell) {
    for (int axis = 0; axis < 3; axis++) {
      originVoxel[axis] = whole.firstVoxel(axis, firstCell[axis]);
    }
  }

  private static int ceilDiv(int a, int b) {
    return (a + b - 1) / b;
  }

  /** Returns the layout with cells of twice the edge, whose nodes are every second one of these. */
  LatticeLayout coarser() {
    int[] voxels = new int[3];
    int[] half = new int[3];
    double[] edge = new double[3];
    for (int axis = 0; axis < 3; axis++) {
      voxels[axis] = 2 * voxelsPerCell[axis];
      half[axis] = cells[axis] / 2;
      edge[axis] = 2 * edgeMm[axis];
    }
    return new LatticeLayout(originVoxel, voxels, half, edge);
  }

  /** Whether {@link #coarser} covers the same box. */
  boolean isEven() {
    return (cells[0] | cells[1] | cells[2]) % 2 == 0;
  }

  /**
   * {@return the number of cells along an axis}
   *
   * @param axis 0 for x, 1 for y, 2 for z
   */
  public int cells(int axis) {
    return cells[axis];
  }

  /** Returns the number of cells. */
  int cellCount() {
    return cells[0] * cells[1] * cells[2];
  }

  /** {@return the number of nodes} */
  public int nodeCount() {
    return nodesX * nodesY * (cells[2] + 1);
  }

  /**
   * {@return the edge of a cell along an axis, mm}
   *
   * @param axis 0 for x, 1 for y, 2 for z
   */
  public double edgeMm(int axis) {
    return edgeMm[axis];
  }

  /** {@return the longest edge of a cell, mm} */
  public double longestEdgeMm() {
    return Math.max(edgeMm[0], Math.max(edgeMm[1], edgeMm[2]));
  }

  /**
   * {@return the number of voxels in a cell along an axis}
   *
   * @param axis 0 for x, 1 for y, 2 for z
   */
  public int voxelsPerCell(int axis) {
    return voxelsPerCell[axis];
  }

  /** Returns the first voxel of the cells with this index along an axis. */
  int firstVoxel(int axis, int cell) {
    return originVoxel[axis] + cell * voxelsPerCell[axis];
  }

  /**
   * {@return the grid coordinate at which the lattice begins along an axis}
   *
   * @param axis 0 for x, 1 for y, 2 for z
   */
  public int originVoxel(int axis) {
    return originVoxel[axis];
  }

  /**
   * Returns the index along an axis of the cell that holds a voxel; may lie outside the lattice.
   */
  int cellOfVoxel(int axis, int voxel) {
    return Math.floorDiv(voxel - originVoxel[axis], voxelsPerCell[axis]);
  }

  /**
   * {@return the number of a node}
   *
   * @param x the index of the node along x, from 0
   * @param y its index along y
   * @param z its index along z
   */
  public int node(int x, int y, int z) {
    return x + nodesX * (y + nodesY * z);
  }

  /**
   * {@return the index of a node along an axis}
   *
   * @param axis 0 for x, 1 for y, 2 for z
   * @param node the number of the node
   */
  public int nodeIndex(int axis, int node) {
    return switch (axis) {
      case 0 -> node % nodesX;
      case 1 -> node / nodesX % nodesY;
      default -> node / nodesX / nodesY;
    };
  }

  /**
   * {@return whether a node lies on the sides of the lattice}
   *
   * @param node the number of the node
   */
  public boolean isOnRim(int node) {
    for (int axis = 0; axis < 3; axis++) {
      int index = nodeIndex(axis, node);
      if (index == 0 || index == cells[axis]) {
        return true;
      }
    }
    return false;
  }

  /** Returns the number of a cell. */
  int cell(int x, int y, int z) {
    return x + cells[0] * (y + cells[1] * z);
  }

  /** Returns the number of the cell with these indices, or -1 if they lie outside the lattice. */
  int cellOrNone(int x, int y, int z) {
    boolean inside = x >= 0 && y >= 0 && z >= 0 && x < cells[0] && y < cells[1] && z < cells[2];
    return inside ? cell(x, y, z) : -1;
  }

  /** Returns the index of a cell along an axis. */
  int cellIndex(int axis, int cell) {
    return switch (axis) {
      case 0 -> cell % cells[0];
      case 1 -> cell / cells[0] % cells[1];
      default -> cell / cells[0] / cells[1];
    };
  }

  /**
   * Writes a cell and those that share a node with it into {@code dest}.
   *
   * @param dest room for {@link #MOST_NEIGHBOURS}
   * @return the number of these cells
   */
  int neighbours(int cell, int[] dest) {
    int x = cellIndex(0, cell);
    int y = cellIndex(1, cell);
    int z = cellIndex(2, cell);
    int count = 0;
    for (int k = Math.max(0, z - 1); k <= Math.min(cells[2] - 1, z + 1); k++) {
      for (int j = Math.max(0, y - 1); j <= Math.min(cells[1] - 1, y + 1); j++) {
        for (int i = Math.max(0, x - 1); i <= Math.min(cells[0] - 1, x + 1); i++) {
          dest[count++] = cell(i, j, k);
        }
      }
    }
    return count;
  }

  /** Returns the node at corner 0 of a cell. */
  int firstNode(int cell) {
    return node(cellIndex(0, cell), cellIndex(1, cell), cellIndex(2, cell));
  }

  /**
   * {@return the number to add to that of a cell's first node, for the node at a corner}
   *
   * @param corner the number of the corner: bit 0 is its step along x, bit 1 along y, bit 2 along z
   */
  public int cornerOffset(int corner) {
    return cornerOffsets[corner];
  }
}
