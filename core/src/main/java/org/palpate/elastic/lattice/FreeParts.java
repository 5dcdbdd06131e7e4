package org.palpate.elastic.lattice;

import java.util.Arrays;

/**
 * Finds the parts of an elastic body that edits have cut off from all support. A part is a set of
 * cells with matter that share nodes. It is supported if one of its nodes is fixed. A part that had
 * no support from the start does not count.
 *
 * <p>One thread; allocates nothing after construction. A search visits each cell with matter once.
 */
final class FreeParts {
  private final ActiveCells cells;
  private final float[] solidModulus;

  /** Whether a cell belonged to a supported part at the start. */
  private final boolean[] stood;

  private final boolean[] visited;

  /** The cells of the part that is being searched, in the order of the search. */
  private final int[] queue;

  private final int[] neighbours = new int[LatticeLayout.MOST_NEIGHBOURS];
  private int found;
  private boolean supported;

  /**
   * Notes which parts have support.
   *
   * @param solidModulus the elastic modulus of each listed cell, 0 without matter; kept, because
   *     edits change it later
   */
  FreeParts(ActiveCells cells, float[] solidModulus) {
    this.cells = cells;
    this.solidModulus = solidModulus;
    stood = new boolean[cells.count()];
    visited = new boolean[cells.count()];
    queue = new int[cells.count()];
    for (int cell = 0; cell < stood.length; cell++) {
      if (isNew(cell)) {
        searchPart(cell);
        for (int n = 0; n < found; n++) {
          stood[queue[n]] = supported;
        }
      }
    }
  }

  /**
   * Searches all parts.
   *
   * @param free receives for each node whether it belongs to a part that has lost its support
   * @return the number of these parts
   */
  int find(boolean[] free) {
    Arrays.fill(free, false);
    Arrays.fill(visited, false);
    int count = 0;
    for (int cell = 0; cell < stood.length; cell++) {
      if (isNew(cell)) {
        searchPart(cell);
        if (!supported && oneStood()) {
          count++;
          mark(free);
        }
      }
    }
    return count;
  }

  /**
   * Returns a search that also counts parts that had no support from the start.
   *
   * @param solidModulus of each listed cell
   */
  static FreeParts ofAll(ActiveCells cells, float[] solidModulus) {
    FreeParts parts = new FreeParts(cells, solidModulus);
    Arrays.fill(parts.stood, true);
    return parts;
  }

  private boolean isNew(int cell) {
    return cell >= 0 && !visited[cell] && solidModulus[cell] > 0;
  }

  private boolean oneStood() {
    boolean any = false;
    for (int n = 0; n < found; n++) {
      any |= stood[queue[n]];
    }
    return any;
  }

  private void mark(boolean[] free) {
    for (int n = 0; n < found; n++) {
      for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
        free[cells.firstNode(queue[n]) + cells.layout().cornerOffset(corner)] = true;
      }
    }
  }

  /** Collects the part of a cell, and finds whether it has support. */
  private void searchPart(int first) {
    found = 0;
    supported = false;
    append(first);
    for (int n = 0; n < found; n++) {
      int cell = queue[n];
      for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
        supported |= cells.isFixed(cells.firstNode(cell) + cells.layout().cornerOffset(corner));
      }
      appendNeighbours(cells.cell(cell));
    }
  }

  private void append(int cell) {
    visited[cell] = true;
    queue[found++] = cell;
  }

  private void appendNeighbours(int cell) {
    int count = cells.layout().neighbours(cell, neighbours);
    for (int n = 0; n < count; n++) {
      int listed = cells.indexOf(neighbours[n]);
      if (isNew(listed)) {
        append(listed);
      }
    }
  }
}
