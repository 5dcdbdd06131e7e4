package org.palpate.elastic;

import org.palpate.elastic.lattice.LatticeLayout;

/**
 * Kuhn's division of a cell into six tetrahedra. Each follows the edges from corner 0 to corner 7
 * along the three axes in one order.
 *
 * <p>A value between the nodes is affine on each tetrahedron. Methods work on arrays of the caller,
 * because the haptic thread calls them many times in a frame.
 *
 * <p>Reference: Kuhn 1960, "Some combinatorial lemmas in topology".
 */
public final class KuhnTetrahedra {
  /** The orders of the axes. */
  static final int[][] ORDERS = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

  /** The number of entries of the corners of a cell: entry 3 c + a is corner c along axis a. */
  static final int ENTRIES = 3 * LatticeLayout.CORNERS;

  private KuhnTetrahedra() {}

  /**
   * Finds the tetrahedron of a point in a lattice.
   *
   * @param at the point, in cells from the first node
   * @param cells the number of cells along each axis
   * @param cell receives the index of the cell along each axis
   * @param order receives the order of the axes
   * @param along receives the position along the edges: 1 &gt;= first &gt;= second &gt;= third
   *     &gt;= 0
   * @return false outside the lattice; then nothing is written
   */
  public static boolean find(double[] at, int[] cells, int[] cell, int[] order, double[] along) {
    double x = at[0];
    double y = at[1];
    double z = at[2];
    if (!(x >= 0 && x <= cells[0] && y >= 0 && y <= cells[1] && z >= 0 && z <= cells[2])) {
      return false;
    }
    cell[0] = Math.min((int) x, cells[0] - 1);
    cell[1] = Math.min((int) y, cells[1] - 1);
    cell[2] = Math.min((int) z, cells[2] - 1);
    sort(x - cell[0], y - cell[1], z - cell[2], order, along);
    return true;
  }

  /**
   * Sorts positions in a cell from the largest to the least. Both methods are written out for the
   * three axes: as loops over arrays they made the map forward, back and its gradient 7 % slower.
   */
  static void sort(double x, double y, double z, int[] order, double[] along) {
    boolean exchanged = x < y;
    double most = exchanged ? y : x;
    double middle = exchanged ? x : y;
    int first = exchanged ? 1 : 0;
    int second = exchanged ? 0 : 1;
    int third = 2;
    double least = z;
    if (middle < least) {
      least = middle;
      middle = z;
      third = second;
      second = 2;
    }
    if (most < middle) {
      double other = most;
      most = middle;
      middle = other;
      second = first;
      first = 2;
    }
    order[0] = first;
    order[1] = second;
    order[2] = third;
    along[0] = most;
    along[1] = middle;
    along[2] = least;
  }

  /** Exchanges two axes that follow one another: goes to the tetrahedron behind a face. */
  static void swap(int n, int[] order) {
    int first = order[n];
    order[n] = order[n + 1];
    order[n + 1] = first;
  }

  /**
   * Writes the weights of the four nodes on the path from corner 0 to corner 7; they sum to 1.
   *
   * @param along the positions in the cell along the edges of the path, three numbers in falling
   *     order
   * @param dest receives the four weights, that of corner 0 first
   */
  public static void weigh(double[] along, double[] dest) {
    dest[0] = 1 - along[0];
    dest[1] = along[0] - along[1];
    dest[2] = along[1] - along[2];
    dest[3] = along[2];
  }

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
