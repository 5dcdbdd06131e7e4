package org.palpate.elastic;

import java.math.BigDecimal;
import java.util.function.IntFunction;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
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
    LatticeLayout layout = lattice.layout();
    IntFunction<double[]> position = node -> vector(axis -> map.nodePosition(node, axis));
    DeformationField field = map.field();
    if (!field.hasWindow()) {
      return folded(layout, node -> true, position);
    }
    LatticeLayout inWindow = field.window.nodes().layout();
    return folded(layout, node -> !isCovered(field, layout, node), position)
        + folded(
            inWindow,
            node -> true,
            node ->
                vector(
                    axis -> inWindow.nodeIndex(axis, node) + map.windowDisplacement(node, axis)));
  }

  private static double[] vector(IntToDoubleFunction component) {
    return IntStream.range(0, 3).mapToDouble(component).toArray();
  }

  /** Whether the window takes the place of the cell that begins at a node. */
  private static boolean isCovered(DeformationField field, LatticeLayout layout, int node) {
    return field.window.covers(
        layout.nodeIndex(0, node), layout.nodeIndex(1, node), layout.nodeIndex(2, node));
  }

  /** Counts in the chosen ones of the cells, each of which begins at a node. */
  private static long folded(
      LatticeLayout layout, IntPredicate chosen, IntFunction<double[]> position) {
    return IntStream.range(0, layout.nodeCount())
        .filter(node -> IntStream.range(0, 3).allMatch(a -> isBeforeLast(layout, a, node)))
        .filter(chosen)
        .mapToLong(node -> foldedOf(corners(layout, node, position)))
        .sum();
  }

  private static boolean isBeforeLast(LatticeLayout layout, int axis, int node) {
    return layout.nodeIndex(axis, node) < layout.cells(axis);
  }

  private static double[][] corners(
      LatticeLayout layout, int first, IntFunction<double[]> position) {
    double[][] corners = new double[8][];
    for (int n = 0; n < corners.length; n++) {
      corners[n] = position.apply(first + layout.node(n & 1, n >> 1 & 1, n >> 2));
    }
    return corners;
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
