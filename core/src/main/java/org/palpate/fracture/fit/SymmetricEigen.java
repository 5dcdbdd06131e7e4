package org.palpate.fracture.fit;

/**
 * The eigenvalues and eigenvectors of a small symmetric matrix, by Jacobi rotations. One thread an
 * instance.
 *
 * <p>Reference: Golub, Van Loan, Matrix Computations, 2013, section 8.5.
 */
final class SymmetricEigen {
  private static final int MOST_SWEEPS = 30;

  private final int size;
  private final double[][] a;
  private final double[][] vectors;

  /**
   * Decomposes a matrix.
   *
   * @param matrix symmetric and finite; not changed
   */
  SymmetricEigen(double[][] matrix) {
    size = matrix.length;
    a = new double[size][];
    vectors = new double[size][size];
    for (int n = 0; n < size; n++) {
      a[n] = matrix[n].clone();
      vectors[n][n] = 1;
    }
    for (int sweep = 0; sweep < MOST_SWEEPS && !isDiagonal(); sweep++) {
      for (int p = 0; p < size; p++) {
        for (int q = p + 1; q < size; q++) {
          rotate(p, q);
        }
      }
    }
  }

  /** Returns an eigenvalue. */
  double value(int n) {
    return a[n][n];
  }

  /** Returns a component of the unit eigenvector of an eigenvalue. */
  double component(int n, int row) {
    return vectors[row][n];
  }

  private boolean isDiagonal() {
    double beside = 0;
    double on = 0;
    for (int p = 0; p < size; p++) {
      on += a[p][p] * a[p][p];
      for (int q = p + 1; q < size; q++) {
        beside += a[p][q] * a[p][q];
      }
    }
    return beside <= 1e-30 * on;
  }

  /** Makes the entry of two rows zero. */
  private void rotate(int p, int q) {
    if (a[p][q] == 0) {
      return;
    }
    double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    double t = Math.copySign(1, theta) / (Math.abs(theta) + Math.sqrt(theta * theta + 1));
    double c = 1 / Math.sqrt(t * t + 1);
    double s = t * c;
    for (int n = 0; n < size; n++) {
      double left = a[n][p];
      double right = a[n][q];
      a[n][p] = c * left - s * right;
      a[n][q] = s * left + c * right;
    }
    for (int n = 0; n < size; n++) {
      double left = a[p][n];
      double right = a[q][n];
      a[p][n] = c * left - s * right;
      a[q][n] = s * left + c * right;
      left = vectors[n][p];
      right = vectors[n][q];
      vectors[n][p] = c * left - s * right;
      vectors[n][q] = s * left + c * right;
    }
  }
}
