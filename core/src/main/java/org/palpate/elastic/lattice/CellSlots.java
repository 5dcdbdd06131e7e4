package org.palpate.elastic.lattice;

import java.util.Arrays;

/**
 * The order in which {@link StiffnessOperator} handles the listed cells. A run is a range of slots
 * whose first nodes follow one another, within one tile. Where few nodes lie between two listed
 * cells, they have slots without a cell: so the cells of a whole layer can be one run. Immutable;
 * any thread.
 */
final class CellSlots {
  /** The most slots without a cell between two cells; a new run would take longer. */
  private static final int MOST_EMPTY = 8;

  private final int[] slotOfCell;

  /** The first node of each run. */
  private final int[] nodes;

  /** The first slot of each run, and the number of slots at the end. */
  private final int[] begins;

  /**
   * Orders the cells.
   *
   * @param tile the number of slots in a tile
   */
  CellSlots(ActiveCells cells, int tile) {
    slotOfCell = new int[cells.count()];
    int slots = 0;
    for (int cell = 0; cell < slotOfCell.length; cell++) {
      slots += cell == 0 ? 0 : step(cells, cell);
      slotOfCell[cell] = slots;
    }
    slots += slotOfCell.length == 0 ? 0 : 1;
    int[] nodeOfRun = new int[slots];
    int[] beginOfRun = new int[slots + 1];
    int runs = 0;
    for (int cell = 0; cell < slotOfCell.length; cell++) {
      int slot = slotOfCell[cell];
      int from = cell == 0 ? slot : slotOfCell[cell - 1] + 1;
      boolean follows = cell > 0 && isNear(cells, cell);
      for (int at = from; at <= slot; at++) {
        if (!follows || at % tile == 0) {
          nodeOfRun[runs] = cells.firstNode(cell) - (slot - at);
          beginOfRun[runs] = at;
          runs++;
        }
      }
    }
    beginOfRun[runs] = slots;
    nodes = Arrays.copyOf(nodeOfRun, runs);
    begins = Arrays.copyOf(beginOfRun, runs + 1);
  }

  /** Whether only few nodes lie between a cell and the one before. */
  private static boolean isNear(ActiveCells cells, int cell) {
    return cells.firstNode(cell) - cells.firstNode(cell - 1) <= MOST_EMPTY + 1;
  }

  /** Returns how many slots a cell comes after the one before. */
  private static int step(ActiveCells cells, int cell) {
    return isNear(cells, cell) ? cells.firstNode(cell) - cells.firstNode(cell - 1) : 1;
  }

  /** Returns the number of slots. */
  int count() {
    return begins[nodes.length];
  }

  /** Returns the number of runs. */
  int runs() {
    return nodes.length;
  }

  /** Returns the first node of the first slot of a run. */
  int node(int run) {
    return nodes[run];
  }

  /** Returns the first slot of a run; that of the run after the last is the number of slots. */
  int begin(int run) {
    return begins[run];
  }

  /** Copies numbers of the listed cells to their slots. */
  void spread(float[] ofCells, float[] dest) {
    for (int cell = 0; cell < slotOfCell.length; cell++) {
      dest[slotOfCell[cell]] = ofCells[cell];
    }
  }
}
