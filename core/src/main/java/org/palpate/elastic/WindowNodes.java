package org.palpate.elastic;

import org.palpate.elastic.lattice.LatticeLayout;
import org.palpate.elastic.lattice.WindowLattice;

/**
 * The nodes of a window, and the nodes of the whole lattice between which each stands. A node of
 * the window lies in a Kuhn tetrahedron of the whole lattice, or on its faces; the Kuhn tetrahedra
 * of the window divide it.
 *
 * <p>Immutable; any thread.
 */
final class WindowNodes {
  /** The nodes of a tetrahedron. */
  private static final int AROUND = 4;

  /** Values of this exponent or less count as zero. */
  private static final int LEAST_EXPONENT = -100;

  private final LatticeLayout whole;
  private final LatticeLayout layout;
  private final int factor;

  /** The nodes of the whole lattice, as numbers to add to that of the window's first one. */
  private final int[] around;

  private final double[] weights;
  private final boolean[] onRim;

  /** Takes the numbers of nodes and cells of a window, which do not depend on its place. */
  WindowNodes(LatticeLayout whole, WindowLattice window) {
    this.whole = whole;
    layout = window.layout();
    factor = window.factor();
    around = new int[AROUND * layout.nodeCount()];
    weights = new double[around.length];
    onRim = new boolean[layout.nodeCount()];
    for (int node = 0; node < onRim.length; node++) {
      onRim[node] = layout.isOnRim(node);
      findAround(node);
    }
  }

  private void findAround(int node) {
    double[] at = new double[3];
    int[] cells = new int[3];
    for (int axis = 0; axis < 3; axis++) {
      at[axis] = (double) layout.nodeIndex(axis, node) / factor;
      cells[axis] = wholeCells(axis);
    }
    int[] cell = new int[3];
    int[] order = new int[3];
    double[] along = new double[3];
    KuhnTetrahedra.find(at, cells, cell, order, along);
    double[] of = new double[AROUND];
    KuhnTetrahedra.weigh(along, of);
    int corner = 0;
    for (int n = 0; n < AROUND; n++) {
      around[AROUND * node + n] =
          whole.node(cell[0], cell[1], cell[2]) + whole.cornerOffset(corner);
      weights[AROUND * node + n] = of[n];
      corner |= n < 3 ? 1 << order[n] : 0;
    }
  }

  /** Returns the layout of the window; only its place in the grid may change. */
  LatticeLayout layout() {
    return layout;
  }

  /** Returns the number of cells along the edge of a cell of the whole lattice. */
  int factor() {
    return factor;
  }

  /** Returns the number of cells of the whole lattice in the window along an axis. */
  int wholeCells(int axis) {
    return layout.cells(axis) / factor;
  }

  /** Whether a node lies on the sides of the window. */
  boolean isOnRim(int node) {
    return onRim[node];
  }

  /** Returns the node of the whole lattice at which a window with a first cell begins. */
  int firstNode(int[] firstCell) {
    return whole.node(firstCell[0], firstCell[1], firstCell[2]);
  }

  /**
   * Writes a displacement of the whole lattice at the nodes of the window.
   *
   * @param from three numbers for each node of the whole lattice
   * @param firstNode that of the whole lattice at which the window begins
   * @param dest three numbers for each node of the window
   */
  void interpolate(float[] from, int firstNode, float[] dest) {
    int nodes = onRim.length;
    for (int axis = 0; axis < 3; axis++) {
      int begin = axis * whole.nodeCount() + firstNode;
      for (int node = 0; node < nodes; node++) {
        double sum = 0;
        for (int n = AROUND * node; n < AROUND * node + AROUND; n++) {
          sum += weights[n] * from[begin + around[n]];
        }
        dest[axis * nodes + node] = (float) sum;
      }
    }
  }

  /**
   * Writes the values of a field of the whole lattice at a node of the window, without rounding if
   * {@link #round} rounded them.
   *
   * @param from the values, in cells of the whole lattice
   * @param firstNode the node of the whole lattice at which the window begins
   * @param dest receives the values of the node, in cells of the window
   */
  void interpolateNode(float[] from, int firstNode, int node, float[] dest) {
    int to = DeformationField.STRIDE * node;
    for (int value = 0; value < DeformationField.STRIDE; value++) {
      double sum = 0;
      for (int n = AROUND * node; n < AROUND * node + AROUND; n++) {
        int wholeNode = firstNode + around[n];
        sum += weights[n] * from[DeformationField.STRIDE * wholeNode + value];
      }
      dest[to + value] = (float) (factor * sum);
    }
  }

  /**
   * Rounds the values of a field of the whole lattice, by at most 2^-22 of the largest one of their
   * kind, so that those of the window between them are floats.
   */
  static void round(float[] values) {
    for (int kind = 0; kind < DeformationField.STRIDE; kind += 3) {
      float most = 0;
      for (int at = kind; at < values.length; at += DeformationField.STRIDE) {
        most = Math.max(most, Math.abs(values[at]));
        most = Math.max(most, Math.abs(values[at + 1]));
        most = Math.max(most, Math.abs(values[at + 2]));
      }
      // A value less than 2^e plus 3 * 2^e keeps the bits from 2^(e - 22) on.
      int exponent = Math.getExponent(most) + 1;
      boolean none = exponent <= LEAST_EXPONENT;
      float keep = Math.scalb(3f, exponent);
      for (int at = kind; at < values.length; at += DeformationField.STRIDE) {
        for (int n = at; n < at + 3; n++) {
          values[n] = none ? 0 : values[n] + keep - keep;
        }
      }
    }
  }
}
