package org.palpate.elastic.lattice;

/**
 * The stiffness matrix of a box-shaped trilinear hexahedron with Wilson's incompatible modes, for a
 * Young's modulus of 1 N/mm^2. The modes let one cell bend without locking.
 *
 * <p>Degree of freedom 3 c + a is the displacement of corner c along axis a.
 *
 * <p>Reference: Wilson, Taylor, Doherty, Ghaboussi 1973, "Incompatible displacement models".
 */
final class HexahedronStiffness {
  /** The degrees of freedom of a cell. */
  static final int SIZE = 3 * LatticeLayout.CORNERS;

  private static final int MODES = 3;
  private static final int FUNCTIONS = LatticeLayout.CORNERS + MODES;
  private static final double GAUSS = 0.5 / Math.sqrt(3);
  private static final double[] FULL = {1, 1, 1};

  private HexahedronStiffness() {}

  /**
   * Returns the matrix of a full cell by rows, N/mm.
   *
   * @param poisson Poisson's ratio
   * @param layout gives the edges of the cell
   */
  static float[] of(double poisson, LatticeLayout layout) {
    return of(poisson, layout, FULL);
  }

  /**
   * Returns the matrix of a cell with other second moments by rows, N/mm.
   *
   * @param moments along each axis, over those of a full cell
   */
  static float[] of(double poisson, LatticeLayout layout, double[] moments) {
    double lambda = poisson / ((1 + poisson) * (1 - 2 * poisson));
    double shear = 1 / (2 * (1 + poisson));
    double[][] matrix = new double[3 * FUNCTIONS][3 * FUNCTIONS];
    double mm3 = layout.edgeMm(0) * layout.edgeMm(1) * layout.edgeMm(2);
    for (int point = 0; point < LatticeLayout.CORNERS; point++) {
      double[][] gradients = gradients(point, layout, moments);
      addPoint(gradients, lambda * mm3 / 8, shear * mm3 / 8, matrix);
    }
    condenseModes(matrix);
    return symmetric(matrix);
  }

  /** Returns the gradients of the shape functions and the modes at a Gauss point, 1/mm. */
  private static double[][] gradients(int point, LatticeLayout layout, double[] moments) {
    double[] at = new double[3];
    for (int axis = 0; axis < 3; axis++) {
      double away = GAUSS * Math.sqrt(moments[axis]);
      at[axis] = 0.5 + ((point >> axis & 1) == 1 ? away : -away);
    }
    double[][] gradients = new double[FUNCTIONS][3];
    for (int axis = 0; axis < 3; axis++) {
      for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
        gradients[corner][axis] = derivative(corner, axis, at) / layout.edgeMm(axis);
      }
      // The mode 1 - (2 x - 1)^2 of this axis.
      gradients[LatticeLayout.CORNERS + axis][axis] = -4 * (2 * at[axis] - 1) / layout.edgeMm(axis);
    }
    return gradients;
  }

  private static double derivative(int corner, int axis, double[] at) {
    double product = 1;
    for (int other = 0; other < 3; other++) {
      boolean upper = (corner >> other & 1) == 1;
      if (other == axis) {
        product *= upper ? 1 : -1;
      } else {
        product *= upper ? at[other] : 1 - at[other];
      }
    }
    return product;
  }

  private static void addPoint(double[][] g, double lambda, double shear, double[][] dest) {
    for (int i = 0; i < FUNCTIONS; i++) {
      for (int j = 0; j < FUNCTIONS; j++) {
        double dot = g[i][0] * g[j][0] + g[i][1] * g[j][1] + g[i][2] * g[j][2];
        for (int a = 0; a < 3; a++) {
          for (int b = 0; b < 3; b++) {
            dest[3 * i + a][3 * j + b] +=
                lambda * g[i][a] * g[j][b] + shear * (g[i][b] * g[j][a] + (a == b ? dot : 0));
          }
        }
      }
    }
  }

  /** Eliminates the modes, the last rows and columns, one by one. */
  private static void condenseModes(double[][] matrix) {
    for (int mode = matrix.length - 1; mode >= SIZE; mode--) {
      for (int row = 0; row < mode; row++) {
        double factor = matrix[row][mode] / matrix[mode][mode];
        for (int column = 0; column < mode; column++) {
          matrix[row][column] -= factor * matrix[mode][column];
        }
      }
    }
  }

  private static float[] symmetric(double[][] matrix) {
    float[] rows = new float[SIZE * SIZE];
    for (int row = 0; row < SIZE; row++) {
      for (int column = 0; column < SIZE; column++) {
        rows[SIZE * row + column] = (float) (0.5 * (matrix[row][column] + matrix[column][row]));
      }
    }
    return rows;
  }
}
