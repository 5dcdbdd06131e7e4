package org.palpate.elastic.lattice;

import java.util.Arrays;

/**
 * The cells that can deform, those with a node that is not fixed, in a list. All other nodes and
 * cells stand still. Immutable, any thread; those of a window belong to the thread that solves,
 * which fixes other nodes when the window moves.
 */
public final class ActiveCells {
  private static final int NOT_LISTED = -1;

  /**
   * The share of fixed nodes around a coarse node that fixes it, by their weights in trilinear
   * interpolation. A plane of fixed nodes beside the coarse node has 0.25, so it does not.
   */
  private static final double FIXING_SHARE = 0.3;

  private final LatticeLayout layout;
  private final boolean[] fixed;
  private final int[] cells;
  private final int[] firstNodes;
  private final int[] indexOfCell;

  /**
   * Lists the cells.
   *
   * @param fixed for each node whether it is fixed; must hold for every node on the rim
   */
  ActiveCells(LatticeLayout layout, boolean[] fixed) {
    this.layout = layout;
    this.fixed = fixed;
    indexOfCell = new int[layout.cellCount()];
    Arrays.fill(indexOfCell, NOT_LISTED);
    int[] list = new int[indexOfCell.length];
    int count = 0;
    for (int cell = 0; cell < list.length; cell++) {
      if (hasFreeNode(cell)) {
        indexOfCell[cell] = count;
        list[count++] = cell;
      }
    }
    cells = Arrays.copyOf(list, count);
    firstNodes = new int[count];
    for (int index = 0; index < count; index++) {
      firstNodes[index] = layout.firstNode(cells[index]);
    }
  }

  private boolean hasFreeNode(int cell) {
    int first = layout.firstNode(cell);
    for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
      if (!fixed[first + layout.cornerOffset(corner)]) {
        return true;
      }
    }
    return false;
  }

  /**
   * Returns the list on cells of twice the edge. A node is fixed if enough of the fine nodes around
   * it are. If only the same fine node counted, an uneven support would be much too soft on the
   * coarse cells, and conjugate gradients would need twice as many iterations.
   */
  ActiveCells coarser() {
    LatticeLayout coarse = layout.coarser();
    boolean[] coarseFixed = new boolean[coarse.nodeCount()];
    fixCoarse(coarse, coarseFixed);
    return new ActiveCells(coarse, coarseFixed);
  }

  private void fixCoarse(LatticeLayout coarse, boolean[] coarseFixed) {
    for (int node = 0; node < coarseFixed.length; node++) {
      coarseFixed[node] = fixedShare(coarse, node) >= FIXING_SHARE;
    }
  }

  /**
   * Fixes other nodes. The list stays, so it must hold each cell with a node that is free now.
   *
   * @param nodes for each node whether it is fixed; must hold for every node on the rim
   */
  void fix(boolean[] nodes) {
    System.arraycopy(nodes, 0, fixed, 0, fixed.length);
  }

  /** Fixes the nodes of a list that {@link #coarser} returned, after {@link #fix} of this one. */
  void fixAgain(ActiveCells coarse) {
    fixCoarse(coarse.layout, coarse.fixed);
  }

  /** Returns the share of fixed nodes among those of the lattice around a coarse node. */
  private double fixedShare(LatticeLayout coarse, int node) {
    int x = 2 * coarse.nodeIndex(0, node);
    int y = 2 * coarse.nodeIndex(1, node);
    int z = 2 * coarse.nodeIndex(2, node);
    double all = 0;
    double share = 0;
    for (int k = Math.max(0, z - 1); k <= Math.min(layout.cells(2), z + 1); k++) {
      for (int j = Math.max(0, y - 1); j <= Math.min(layout.cells(1), y + 1); j++) {
        for (int i = Math.max(0, x - 1); i <= Math.min(layout.cells(0), x + 1); i++) {
          int away = Math.abs(i - x) + Math.abs(j - y) + Math.abs(k - z);
          double weight = 1.0 / (1 << away);
          all += weight;
          share += fixed[layout.node(i, j, k)] ? weight : 0;
        }
      }
    }
    return share / all;
  }

  /** Returns the node of this lattice at the place of a node of the coarser one. */
  int fineNode(LatticeLayout coarse, int node) {
    return layout.node(
        2 * coarse.nodeIndex(0, node),
        2 * coarse.nodeIndex(1, node),
        2 * coarse.nodeIndex(2, node));
  }

  /** {@return the layout} */
  public LatticeLayout layout() {
    return layout;
  }

  /** {@return the number of listed cells} */
  public int count() {
    return cells.length;
  }

  /** Returns the cell at a place of the list. */
  int cell(int index) {
    return cells[index];
  }

  /** Returns the place of a cell in the list, or a negative number if it is not listed. */
  int indexOf(int cell) {
    return indexOfCell[cell];
  }

  /**
   * {@return the node at corner 0 of a listed cell}
   *
   * @param index the place of the cell in the list
   */
  public int firstNode(int index) {
    return firstNodes[index];
  }

  /**
   * {@return whether a node is fixed}
   *
   * @param node the number of the node in the layout
   */
  public boolean isFixed(int node) {
    return fixed[node];
  }
}
