package org.palpate.elastic.lattice;

/**
 * The stiffness of a small lattice as a full matrix, summed cell by cell, and its solution by
 * elimination: the plain reference of {@link StiffnessOperator} and of the solvers.
 */
final class DenseStiffness {
  private final double[][] matrix;
  private final ActiveCells cells;
  private final int nodes;

  /** Sums the cells of an operator at displacements, from which their rotations come. */
  DenseStiffness(StiffnessOperator stiffness, double poisson, float[] displacement) {
    cells = stiffness.cells();
    nodes = cells.layout().nodeCount();
    matrix = new double[3 * nodes][3 * nodes];
    CellRotations rotations = new CellRotations(cells);
    rotations.update(displacement);
    for (int n = 0; n < cells.count(); n++) {
      double[] r = new double[9];
      for (int entry = 0; entry < 9; entry++) {
        r[entry] = rotations.entries[entry][n];
      }
      double[] moments = new double[3];
      for (int axis = 0; axis < 3; axis++) {
        moments[axis] = stiffness.moment(axis)[n];
      }
      float[] element = HexahedronStiffness.of(poisson, cells.layout(), moments);
      addCell(n, r, element, stiffness.modulus()[n]);
    }
  }

  private void addCell(int cell, double[] r, float[] element, double modulus) {
    for (int row = 0; row < 24; row++) {
      for (int column = 0; column < 24; column++) {
        double sum = 0;
        for (int a = 0; a < 3; a++) {
          for (int b = 0; b < 3; b++) {
            int i = row - row % 3 + a;
            int j = column - column % 3 + b;
            sum += r[3 * (row % 3) + a] * element[24 * i + j] * r[3 * (column % 3) + b];
          }
        }
        matrix[place(cell, row)][place(cell, column)] += modulus * sum;
      }
    }
  }

  private int place(int cell, int freedom) {
    int node = cells.firstNode(cell) + cells.layout().cornerOffset(freedom / 3);
    return freedom % 3 * nodes + node;
  }

  /** Returns the product; zero at fixed nodes. */
  double[] multiply(float[] x) {
    double[] y = new double[x.length];
    for (int row = 0; row < y.length; row++) {
      for (int column = 0; column < y.length && !isFixed(row); column++) {
        y[row] += matrix[row][column] * x[column];
      }
    }
    return y;
  }

  private boolean isFixed(int freedom) {
    return cells.isFixed(freedom % nodes);
  }

  /** Returns the displacement under a load; fixed nodes stay. */
  double[] solve(float[] load) {
    int size = load.length;
    double[][] a = new double[size][size + 1];
    for (int row = 0; row < size; row++) {
      for (int column = 0; column < size; column++) {
        a[row][column] =
            isFixed(row) || isFixed(column) ? (row == column ? 1 : 0) : matrix[row][column];
      }
      a[row][size] = isFixed(row) ? 0 : load[row];
    }
    for (int p = 0; p < size; p++) {
      for (int row = p + 1; row < size; row++) {
        double factor = a[row][p] / a[p][p];
        for (int column = p; column <= size && factor != 0; column++) {
          a[row][column] -= factor * a[p][column];
        }
      }
    }
    double[] x = new double[size];
    for (int row = size - 1; row >= 0; row--) {
      x[row] = a[row][size];
      for (int column = row + 1; column < size; column++) {
        x[row] -= a[row][column] * x[column];
      }
      x[row] /= a[row][row];
    }
    return x;
  }
}
