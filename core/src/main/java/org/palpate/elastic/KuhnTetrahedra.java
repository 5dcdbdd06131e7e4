package org.palpate.elastic;

import org.palpate.elastic.lattice.LatticeLayout;

/**
 * Kuhn's division of a cell into six tetrahedra. Each follows the edges from corner 0 to corner 7
 * along the three axes in one order.
 *
 * <p>Reference: Kuhn 1960, "Some combinatorial lemmas in topology".
 */
final class KuhnTetrahedra {
  /** The orders of the axes. */
  static final int[][] ORDERS = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

  /** The number of entries of the corners of a cell: entry 3 c + a is corner c along axis a. */
  static final int ENTRIES = 3 * LatticeLayout.CORNERS;

  private KuhnTetrahedra() {}

  /** Returns the least of the six determinants, which are 1 at rest; NaN if any is. */
  static double leastDeterminant(double[] corners) {
    double least = Double.POSITIVE_INFINITY;
    for (int[] order : ORDERS) {
      least = Math.min(least, determinant(corners, order));
    }
    return least;
  }

  /**
   * Returns the determinant of the edges of a tetrahedron, with the sign that is positive at rest.
   *
   * @param corners the positions in lattice coordinates
   */
  static double determinant(double[] corners, int[] order) {
    int a = 3 * (1 << order[0]);
    int b = a + 3 * (1 << order[1]);
    double ax = corners[a] - corners[0];
    double ay = corners[a + 1] - corners[1];
    double az = corners[a + 2] - corners[2];
    double bx = corners[b] - corners[a];
    double by = corners[b + 1] - corners[a + 1];
    double bz = corners[b + 2] - corners[a + 2];
    double cx = corners[21] - corners[b];
    double cy = corners[22] - corners[b + 1];
    double cz = corners[23] - corners[b + 2];
    double value = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
    return order[1] == (order[0] + 1) % 3 ? value : -value;
  }
}
