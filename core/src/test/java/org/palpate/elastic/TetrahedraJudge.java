package org.palpate.elastic;

import java.math.BigDecimal;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.LatticeLayout;

/**
 * Decides in exact arithmetic whether every Kuhn tetrahedron of a deformation, as the haptic thread
 * computes its corners, is positive. It walks all cells of the lattice, listed or not.
 */
final class TetrahedraJudge {
  private TetrahedraJudge() {}

  /** Returns the number of tetrahedra that are not positive. */
  static long folded(ControlLattice lattice, DeformationMap map) {
    LatticeLayout layout = lattice.layout();
    long folded = 0;
    double[][] corner = new double[8][3];
    for (int z = 0; z < layout.cells(2); z++) {
      for (int y = 0; y < layout.cells(1); y++) {
        for (int x = 0; x < layout.cells(0); x++) {
          for (int n = 0; n < 8; n++) {
            int node = layout.node(x + (n & 1), y + (n >> 1 & 1), z + (n >> 2));
            for (int axis = 0; axis < 3; axis++) {
              corner[n][axis] = map.nodePosition(node, axis);
            }
          }
          folded += foldedOf(corner);
        }
      }
    }
    return folded;
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
