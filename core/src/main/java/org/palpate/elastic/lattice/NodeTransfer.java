package org.palpate.elastic.lattice;

/**
 * Carries vectors between a lattice and the one with cells of twice the edge: trilinear
 * interpolation, and its transpose. Both go along one axis after the other.
 *
 * <p>One thread; allocates nothing after construction.
 */
final class NodeTransfer {
  private final ActiveCells fine;
  private final ActiveCells coarse;
  private final int[] fineNodes = new int[3];
  private final int[] coarseNodes = new int[3];

  /** A vector on coarse nodes along x, and fine ones along y and z. */
  private final float[] coarseX;

  /** A vector on coarse nodes along x and y, and fine ones along z. */
  private final float[] coarseXy;

  /** 1 for a node that is free, and 0 for a fixed one. */
  private final float[] fineFree;

  private final float[] coarseFree;

  NodeTransfer(ActiveCells fine, ActiveCells coarse) {
    this.fine = fine;
    this.coarse = coarse;
    for (int axis = 0; axis < 3; axis++) {
      fineNodes[axis] = fine.layout().cells(axis) + 1;
      coarseNodes[axis] = coarse.layout().cells(axis) + 1;
    }
    coarseX = new float[3 * coarseNodes[0] * fineNodes[1] * fineNodes[2]];
    coarseXy = new float[3 * coarseNodes[0] * coarseNodes[1] * fineNodes[2]];
    fineFree = new float[fine.layout().nodeCount()];
    coarseFree = new float[coarse.layout().nodeCount()];
    takeFixedNodes();
  }

  /** Takes over which nodes are fixed, after a change. */
  void takeFixedNodes() {
    findFree(fine, fineFree);
    findFree(coarse, coarseFree);
  }

  private static void findFree(ActiveCells cells, float[] free) {
    for (int node = 0; node < free.length; node++) {
      free[node] = cells.isFixed(node) ? 0 : 1;
    }
  }

  /** Copies the entries of the nodes that both lattices have. */
  void inject(float[] from, float[] dest) {
    LatticeLayout layout = coarse.layout();
    int nodes = layout.nodeCount();
    for (int node = 0; node < nodes; node++) {
      int same = fine.fineNode(layout, node);
      for (int axis = 0; axis < 3; axis++) {
        dest[axis * nodes + node] = from[axis * fineFree.length + same];
      }
    }
  }

  /** Sums a residual of the fine lattice, zero at fixed nodes, on the coarse one. */
  void restrict(float[] from, float[] dest) {
    halveX(from);
    halve(coarseX, 3 * fineNodes[2], coarseNodes[1], coarseNodes[0], coarseXy);
    halve(coarseXy, 3, coarseNodes[2], coarseNodes[0] * coarseNodes[1], dest);
    for (int axis = 0; axis < 3; axis++) {
      int at = axis * coarseFree.length;
      for (int node = 0; node < coarseFree.length; node++) {
        dest[at + node] *= coarseFree[node];
      }
    }
  }

  private void halveX(float[] from) {
    int rows = 3 * fineNodes[1] * fineNodes[2];
    int last = coarseNodes[0] - 1;
    for (int row = 0; row < rows; row++) {
      int in = row * fineNodes[0];
      int out = row * coarseNodes[0];
      coarseX[out] = from[in] + 0.5f * from[in + 1];
      for (int n = 1; n < last; n++) {
        int at = in + 2 * n;
        coarseX[out + n] = from[at] + 0.5f * (from[at - 1] + from[at + 1]);
      }
      coarseX[out + last] = from[in + 2 * last] + 0.5f * from[in + 2 * last - 1];
    }
  }

  /**
   * Sums fine rows on coarse ones.
   *
   * @param blocks the number of blocks of rows
   * @param rows the number of coarse rows in a block
   * @param length the length of a row
   */
  private static void halve(float[] from, int blocks, int rows, int length, float[] dest) {
    for (int block = 0; block < blocks; block++) {
      int in = block * (2 * rows - 1) * length;
      int out = block * rows * length;
      for (int row = 0; row < rows; row++) {
        int at = in + 2 * row * length;
        int to = out + row * length;
        System.arraycopy(from, at, dest, to, length);
        if (row > 0) {
          addHalf(from, at - length, length, dest, to);
        }
        if (row < rows - 1) {
          addHalf(from, at + length, length, dest, to);
        }
      }
    }
  }

  private static void addHalf(float[] from, int at, int length, float[] dest, int to) {
    for (int n = 0; n < length; n++) {
      dest[to + n] += 0.5f * from[at + n];
    }
  }

  /** Adds a coarse correction, zero at fixed nodes, to a vector of the fine lattice. */
  void prolong(float[] from, float[] dest) {
    refine(from, 3, coarseNodes[2], coarseNodes[0] * coarseNodes[1], coarseXy);
    refine(coarseXy, 3 * fineNodes[2], coarseNodes[1], coarseNodes[0], coarseX);
    int rowsOfAxis = fineNodes[1] * fineNodes[2];
    for (int row = 0; row < 3 * rowsOfAxis; row++) {
      addRefinedX(row * coarseNodes[0], row % rowsOfAxis * fineNodes[0], dest, row * fineNodes[0]);
    }
  }

  /** Writes fine rows, each the mean of the coarse ones around it; see {@link #halve}. */
  private static void refine(float[] from, int blocks, int rows, int length, float[] dest) {
    for (int block = 0; block < blocks; block++) {
      int in = block * rows * length;
      int out = block * (2 * rows - 1) * length;
      for (int row = 0; row < rows; row++) {
        int to = out + 2 * row * length;
        System.arraycopy(from, in + row * length, dest, to, length);
        if (row < rows - 1) {
          mean(from, in + row * length, length, dest, to + length);
        }
      }
    }
  }

  /** Writes the mean of a row and the next one. */
  private static void mean(float[] from, int at, int length, float[] dest, int to) {
    for (int n = 0; n < length; n++) {
      dest[to + n] = 0.5f * (from[at + n] + from[at + length + n]);
    }
  }

  private void addRefinedX(int in, int node, float[] dest, int to) {
    int last = coarseNodes[0] - 1;
    for (int n = 0; n < last; n++) {
      float low = coarseX[in + n];
      float high = coarseX[in + n + 1];
      dest[to + 2 * n] += fineFree[node + 2 * n] * low;
      dest[to + 2 * n + 1] += fineFree[node + 2 * n + 1] * 0.5f * (low + high);
    }
    dest[to + 2 * last] += fineFree[node + 2 * last] * coarseX[in + last];
  }
}
