package org.palpate.elastic.lattice;

import java.util.Arrays;

/**
 * The rotation of each listed cell, the orthogonal factor of its mean deformation gradient. A cell
 * that is nearly flat keeps its last rotation.
 *
 * <p>Reference: Higham 1986, "Computing the polar decomposition". One thread; allocates nothing
 * after construction.
 */
final class CellRotations {
  private static final int ITERATIONS = 8;
  private static final double CONVERGED = 1e-6;

  /** The least determinant of a gradient that has a rotation. */
  private static final double LEAST_DETERMINANT = 0.02;

  /** Entry 3 r + c of the matrix of each cell. */
  final float[][] entries = new float[9][];

  private final ActiveCells cells;
  private final int nodes;
  private final int[] corner = new int[LatticeLayout.CORNERS];
  private final double[] perMm = new double[3];
  private final double[] f = new double[9];

  /** Creates rotations that are the identity. */
  CellRotations(ActiveCells cells) {
    this.cells = cells;
    nodes = cells.layout().nodeCount();
    for (int entry = 0; entry < 9; entry++) {
      entries[entry] = new float[cells.count()];
      Arrays.fill(entries[entry], entry % 4 == 0 ? 1 : 0);
    }
    for (int axis = 0; axis < 3; axis++) {
      perMm[axis] = 0.25 / cells.layout().edgeMm(axis);
    }
    for (int n = 0; n < LatticeLayout.CORNERS; n++) {
      corner[n] = cells.layout().cornerOffset(n);
    }
  }

  /** Computes the rotations from displacements, mm. */
  void update(float[] displacement) {
    for (int cell = 0; cell < cells.count(); cell++) {
      gradient(displacement, cells.firstNode(cell));
      if (rotate()) {
        for (int entry = 0; entry < 9; entry++) {
          entries[entry][cell] = (float) f[entry];
        }
      }
    }
  }

  /** Writes the mean deformation gradient of a cell into {@link #f}. */
  private void gradient(float[] u, int firstNode) {
    for (int row = 0; row < 3; row++) {
      int at = row * nodes + firstNode;
      double a = u[at];
      double b = u[at + corner[1]];
      double c = u[at + corner[2]];
      double d = u[at + corner[3]];
      double e = u[at + corner[4]];
      double g = u[at + corner[5]];
      double h = u[at + corner[6]];
      double i = u[at + corner[7]];
      f[3 * row] = perMm[0] * (b - a + d - c + g - e + i - h);
      f[3 * row + 1] = perMm[1] * (c - a + d - b + h - e + i - g);
      f[3 * row + 2] = perMm[2] * (e - a + g - b + h - c + i - d);
      f[4 * row] += 1;
    }
  }

  /** Replaces {@link #f} by its orthogonal factor. Returns false if it is nearly singular. */
  private boolean rotate() {
    for (int n = 0; n < ITERATIONS; n++) {
      double c0 = f[4] * f[8] - f[5] * f[7];
      double c1 = f[5] * f[6] - f[3] * f[8];
      double c2 = f[3] * f[7] - f[4] * f[6];
      double determinant = f[0] * c0 + f[1] * c1 + f[2] * c2;
      if (n == 0 && !(determinant > LEAST_DETERMINANT)) {
        return false;
      }
      if (average(0.5 / determinant, c0, c1, c2) < CONVERGED) {
        break;
      }
    }
    return true;
  }

  /**
   * Replaces {@link #f} by the mean of itself and its inverse transposed.
   *
   * @param factor half of the inverse of the determinant
   * @return the change of the diagonal
   */
  private double average(double factor, double c0, double c1, double c2) {
    double c3 = f[2] * f[7] - f[1] * f[8];
    double c4 = f[0] * f[8] - f[2] * f[6];
    double c5 = f[1] * f[6] - f[0] * f[7];
    double c6 = f[1] * f[5] - f[2] * f[4];
    double c7 = f[2] * f[3] - f[0] * f[5];
    double c8 = f[0] * f[4] - f[1] * f[3];
    double g0 = 0.5 * f[0] + factor * c0;
    double g4 = 0.5 * f[4] + factor * c4;
    double g8 = 0.5 * f[8] + factor * c8;
    double change = Math.abs(g0 - f[0]) + Math.abs(g4 - f[4]) + Math.abs(g8 - f[8]);
    f[0] = g0;
    f[4] = g4;
    f[8] = g8;
    f[1] = 0.5 * f[1] + factor * c1;
    f[2] = 0.5 * f[2] + factor * c2;
    f[3] = 0.5 * f[3] + factor * c3;
    f[5] = 0.5 * f[5] + factor * c5;
    f[6] = 0.5 * f[6] + factor * c6;
    f[7] = 0.5 * f[7] + factor * c7;
    return change;
  }
}
