package org.palpate.elastic;

import org.palpate.elastic.lattice.LatticeLayout;
import org.palpate.geometry.Vec3;

/** Finds the material point at a position by looking at every tetrahedron. */
final class NaiveInverse {
  private final LatticeLayout layout;
  private final DeformationMap map;

  NaiveInverse(LatticeLayout layout, DeformationMap map) {
    this.layout = layout;
    this.map = map;
  }

  Vec3 find(Vec3 present) {
    double[] x = new double[3];
    for (int axis = 0; axis < 3; axis++) {
      x[axis] = (present.get(axis) - layout.originVoxel(axis)) / layout.voxelsPerCell(axis);
    }
    double best = Double.NEGATIVE_INFINITY;
    Vec3 found = new Vec3();
    for (int cz = 0; cz < layout.cells(2); cz++) {
      for (int cy = 0; cy < layout.cells(1); cy++) {
        for (int cx = 0; cx < layout.cells(0); cx++) {
          for (int[] order : KuhnTetrahedra.ORDERS) {
            int[][] corner = corners(cx, cy, cz, order);
            double[] weights = weights(corner, x);
            double least =
                Math.min(Math.min(weights[0], weights[1]), Math.min(weights[2], weights[3]));
            if (least > best) {
              best = least;
              combine(corner, weights, found);
            }
          }
        }
      }
    }
    return found;
  }

  private static int[][] corners(int x, int y, int z, int[] order) {
    int[][] corner = new int[4][];
    corner[0] = new int[] {x, y, z};
    for (int n = 0; n < 3; n++) {
      corner[n + 1] = corner[n].clone();
      corner[n + 1][order[n]]++;
    }
    return corner;
  }

  /** Solves the barycentric weights by Cramer's rule on four columns. */
  private double[] weights(int[][] corner, double[] x) {
    double[][] p = new double[4][3];
    for (int n = 0; n < 4; n++) {
      int node = layout.node(corner[n][0], corner[n][1], corner[n][2]);
      for (int axis = 0; axis < 3; axis++) {
        p[n][axis] = map.nodePosition(node, axis);
      }
    }
    double whole = volume(p[0], p[1], p[2], p[3]);
    return new double[] {
      volume(x, p[1], p[2], p[3]) / whole,
      volume(p[0], x, p[2], p[3]) / whole,
      volume(p[0], p[1], x, p[3]) / whole,
      volume(p[0], p[1], p[2], x) / whole
    };
  }

  private static double volume(double[] a, double[] b, double[] c, double[] d) {
    double[][] e = new double[3][3];
    for (int axis = 0; axis < 3; axis++) {
      e[0][axis] = b[axis] - a[axis];
      e[1][axis] = c[axis] - a[axis];
      e[2][axis] = d[axis] - a[axis];
    }
    return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1])
        + e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2])
        + e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
  }

  private void combine(int[][] corner, double[] weights, Vec3 dest) {
    for (int axis = 0; axis < 3; axis++) {
      double cells = 0;
      for (int n = 0; n < 4; n++) {
        cells += weights[n] * corner[n][axis];
      }
      dest.set(axis, layout.originVoxel(axis) + cells * layout.voxelsPerCell(axis));
    }
  }
}
