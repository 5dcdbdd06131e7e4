package org.palpate.elastic;

import java.math.BigDecimal;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.LatticeLayout;

/**
 * Decides in exact arithmetic whether every Kuhn tetrahedron of a deformation, as the haptic thread
 * computes its corners, is positive. It walks all cells of the lattice, listed or not, and those of
 * the window instead of the ones under it.
 */
final class TetrahedraJudge {
  private TetrahedraJudge() {}

  /** Returns the number of tetrahedra that are not positive. */
  static long folded(ControlLattice lattice, DeformationMap map) {
    DeformationField field = map.field();
    Present whole =
        (node, axis) -> lattice.layout().nodeIndex(axis, node) + map.displacement(node, axis);
    if (!field.hasWindow()) {
      return folded(lattice.layout(), whole, (x, y, z) -> true);
    }
    LatticeLayout layout = field.window.nodes().layout();
    return folded(lattice.layout(), whole, (x, y, z) -> !field.window.covers(x, y, z))
        + folded(
            layout,
            (node, axis) -> layout.nodeIndex(axis, node) + map.windowDisplacement(node, axis),
            (x, y, z) -> true);
  }

  /** The present position of a node along an axis, in cells. */
  private interface Present {
    double of(int node, int axis);
  }

  /** Chooses cells. */
  private interface Choice {
    boolean takes(int x, int y, int z);
  }

  private static long folded(LatticeLayout layout, Present present, Choice choice) {
    long folded = 0;
    double[][] corner = new double[8][3];
    for (int z = 0; z < layout.cells(2); z++) {
      for (int y = 0; y < layout.cells(1); y++) {
        for (int x = 0; x < layout.cells(0); x++) {
          if (!choice.takes(x, y, z)) {
            continue;
          }
          for (int n = 0; n < 8; n++) {
            int node = layout.node(x + (n & 1), y + (n >> 1 & 1), z + (n >> 2));
            for (int axis = 0; axis < 3; axis++) {
              corner[n][axis] = present.of(node, axis);
            }
          }
          folded += foldedOf(corner);
        }
      }
    }
    return folded;
  }

  /**
   * Returns the number of values on the sides of the window that are not exactly those between the
   * nodes of the whole lattice around them, in the field or in the one before.
   */
  static long gaps(ControlLattice lattice, DeformationField field) {
    if (!field.hasWindow()) {
      return 0;
    }
    long gaps = gaps(lattice.layout(), field, field.whole.values, field.window.values.values);
    return field.slideIntervals == 0
        ? gaps
        : gaps + gaps(lattice.layout(), field, field.whole.earlier, field.window.values.earlier);
  }

  private static long gaps(
      LatticeLayout whole, DeformationField field, float[] values, float[] inWindow) {
    LatticeLayout layout = field.window.nodes().layout();
    int factor = layout.cells(0) / field.window.nodes().wholeCells(0);
    long gaps = 0;
    for (int node = 0; node < layout.nodeCount(); node++) {
      if (layout.isOnRim(node)) {
        for (int n = 0; n < DeformationField.STRIDE; n++) {
          BigDecimal expected =
              between(whole, layout, field.window.firstCell, node, factor, values, n);
          BigDecimal found = new BigDecimal(inWindow[DeformationField.STRIDE * node + n]);
          gaps += expected.compareTo(found) == 0 ? 0 : 1;
        }
      }
    }
    return gaps;
  }

  /**
   * Returns a value in cells of the window. In a Kuhn tetrahedron it is the value at corner 0 plus
   * the differences along the path to corner 7, each times the part of the edge that is passed.
   */
  private static BigDecimal between(
      LatticeLayout whole,
      LatticeLayout layout,
      int[] firstCell,
      int node,
      int factor,
      float[] values,
      int n) {
    int[] cell = new int[3];
    int[] rest = new int[3];
    for (int axis = 0; axis < 3; axis++) {
      int index = layout.nodeIndex(axis, node);
      cell[axis] = firstCell[axis] + index / factor;
      rest[axis] = index % factor;
    }
    BigDecimal last = value(whole, cell, values, n);
    BigDecimal sum = last.multiply(BigDecimal.valueOf(factor));
    boolean[] done = new boolean[3];
    for (int step = 0; step < 3; step++) {
      int axis = -1;
      for (int a = 0; a < 3; a++) {
        if (!done[a] && rest[a] > 0 && (axis < 0 || rest[a] > rest[axis])) {
          axis = a;
        }
      }
      if (axis < 0) {
        break;
      }
      done[axis] = true;
      cell[axis]++;
      BigDecimal next = value(whole, cell, values, n);
      sum = sum.add(next.subtract(last).multiply(BigDecimal.valueOf(rest[axis])));
      last = next;
    }
    return sum;
  }

  private static BigDecimal value(LatticeLayout whole, int[] cell, float[] values, int n) {
    int node = whole.node(cell[0], cell[1], cell[2]);
    return new BigDecimal(values[DeformationField.STRIDE * node + n]);
  }

  private static long foldedOf(double[][] corner) {
    long folded = 0;
    for (int a = 0; a < 3; a++) {
      for (int b = 0; b < 3; b++) {
        if (a != b) {
          int c = 3 - a - b;
          int sign = (b - a + 3) % 3 == 1 ? 1 : -1;
          BigDecimal[][] e = {
            edge(corner[0], corner[1 << a]),
            edge(corner[1 << a], corner[1 << a | 1 << b]),
            edge(corner[1 << a | 1 << b], corner[1 << a | 1 << b | 1 << c])
          };
          BigDecimal det = minor(e, 0, 1, 2).add(minor(e, 1, 2, 0)).add(minor(e, 2, 0, 1));
          folded += sign * det.signum() > 0 ? 0 : 1;
        }
      }
    }
    return folded;
  }

  private static BigDecimal[] edge(double[] from, double[] to) {
    BigDecimal[] edge = new BigDecimal[3];
    for (int axis = 0; axis < 3; axis++) {
      edge[axis] = new BigDecimal(to[axis]).subtract(new BigDecimal(from[axis]));
    }
    return edge;
  }

  private static BigDecimal minor(BigDecimal[][] e, int x, int y, int z) {
    return e[0][x].multiply(e[1][y].multiply(e[2][z]).subtract(e[1][z].multiply(e[2][y])));
  }
}
