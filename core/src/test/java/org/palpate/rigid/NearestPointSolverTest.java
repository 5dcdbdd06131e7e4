package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.testing.Seeds;

class NearestPointSolverTest {
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @Test
  void findsTheSameNearestPointAsATryOfEveryActiveSet() {
    int infeasible = 0;
    for (int n = 0; n < 3000; n++) {
      int dimension = 2 + random.nextInt(6);
      NearestPointSolver solver = randomProblem(dimension, 1 + random.nextInt(9));
      double expected = bruteForce(solver);
      boolean solved = solver.solve();
      assertEquals(expected < Double.POSITIVE_INFINITY, solved, "problem " + n);
      infeasible += solved ? 0 : 1;
      if (solved) {
        assertEquals(expected, squareFromTarget(solver.y, solver.target), 1e-7 * (1 + expected));
        assertOptimal(solver);
      }
    }
    assertTrue(infeasible > 50 && infeasible < 2900, "infeasible: " + infeasible);
  }

  @Test
  void meetsTheOptimalityConditionsWithManyRows() {
    for (int n = 0; n < 2000; n++) {
      NearestPointSolver solver = randomProblem(7, 60);
      for (int row = 0; row < 60; row++) {
        solver.b[row] = -Math.abs(solver.b[row]); // y = 0 is feasible
      }
      assertTrue(solver.solve());
      assertOptimal(solver);
    }
  }

  @Test
  void opposingRowsThatLeaveAGapAreMetAndThoseThatDoNotAreReported() {
    NearestPointSolver solver = new NearestPointSolver(6, 4);
    solver.rows = 2;
    solver.a[0] = 1;
    solver.a[6] = -1;
    solver.b[0] = 1;
    solver.b[1] = -1.5;
    solver.target[0] = 9;
    assertTrue(solver.solve());
    assertEquals(1.5, solver.y[0], 1e-9);
    solver.b[1] = -0.5;
    assertFalse(solver.solve());
  }

  @Test
  void repeatedAndDependentRowsDoNoHarm() {
    for (int n = 0; n < 500; n++) {
      NearestPointSolver solver = randomProblem(6, 12);
      for (int row = 6; row < 12; row++) {
        System.arraycopy(solver.a, 6 * (row - 6), solver.a, 6 * row, 6);
        solver.b[row] = solver.b[row - 6] - (n % 2 == 0 ? 0 : 1e-12);
      }
      if (solver.solve()) {
        assertOptimal(solver);
      }
    }
  }

  private NearestPointSolver randomProblem(int dimension, int rows) {
    NearestPointSolver solver = new NearestPointSolver(dimension, 64);
    solver.rows = rows;
    for (int row = 0; row < rows; row++) {
      double square = 0;
      for (int c = 0; c < dimension; c++) {
        double v = gauss();
        solver.a[row * dimension + c] = v;
        square += v * v;
      }
      for (int c = 0; c < dimension; c++) {
        solver.a[row * dimension + c] /= Math.sqrt(square);
      }
      solver.b[row] = gauss();
    }
    for (int c = 0; c < dimension; c++) {
      solver.target[c] = 3 * gauss();
    }
    return solver;
  }

  private double gauss() {
    return Math.sqrt(-2 * Math.log(1 - random.nextDouble()))
        * Math.cos(2 * Math.PI * random.nextDouble());
  }

  /** The Karush-Kuhn-Tucker conditions. */
  private static void assertOptimal(NearestPointSolver solver) {
    int d = solver.dimension;
    double[] gradient = new double[d];
    for (int c = 0; c < d; c++) {
      gradient[c] = solver.y[c] - solver.target[c];
    }
    double weight = 0;
    for (int j = 0; j < solver.activeCount; j++) {
      int row = solver.active[j];
      weight += solver.multiplier[j];
      assertTrue(solver.multiplier[j] >= 0);
      assertEquals(solver.b[row], solver.along(row), 1e-7);
      for (int c = 0; c < d; c++) {
        gradient[c] -= solver.multiplier[j] * solver.a[row * d + c];
      }
    }
    for (double g : gradient) {
      assertEquals(0, g, 1e-6 * (1 + weight), "multipliers add up to " + weight);
    }
    for (int row = 0; row < solver.rows; row++) {
      assertTrue(solver.along(row) >= solver.b[row] - 1e-8);
    }
  }

  /** Returns the least squared distance over all sets of rows that are met with equality. */
  private static double bruteForce(NearestPointSolver solver) {
    double best = Double.POSITIVE_INFINITY;
    for (int set = 0; set < 1 << solver.rows; set++) {
      if (Integer.bitCount(set) <= solver.dimension) {
        double[] y = onRows(solver, set);
        if (y != null && isFeasible(solver, y)) {
          best = Math.min(best, squareFromTarget(y, solver.target));
        }
      }
    }
    return best;
  }

  private static boolean isFeasible(NearestPointSolver solver, double[] y) {
    for (int row = 0; row < solver.rows; row++) {
      double along = 0;
      for (int c = 0; c < solver.dimension; c++) {
        along += solver.a[row * solver.dimension + c] * y[c];
      }
      if (along < solver.b[row] - 1e-7) {
        return false;
      }
    }
    return true;
  }

  private static double squareFromTarget(double[] y, double[] target) {
    double sum = 0;
    for (int c = 0; c < y.length; c++) {
      sum += (y[c] - target[c]) * (y[c] - target[c]);
    }
    return sum;
  }

  /** Projects the target onto the rows of a set by Gauss elimination of the normal equations. */
  private static double[] onRows(NearestPointSolver solver, int set) {
    int d = solver.dimension;
    int[] rows = new int[Integer.bitCount(set)];
    for (int row = 0, n = 0; row < solver.rows; row++) {
      if ((set >> row & 1) != 0) {
        rows[n++] = row;
      }
    }
    int k = rows.length;
    double[][] m = new double[k][k + 1];
    for (int i = 0; i < k; i++) {
      m[i][k] = solver.b[rows[i]];
      for (int c = 0; c < d; c++) {
        m[i][k] -= solver.a[rows[i] * d + c] * solver.target[c];
        for (int j = 0; j < k; j++) {
          m[i][j] += solver.a[rows[i] * d + c] * solver.a[rows[j] * d + c];
        }
      }
    }
    double[] u = eliminate(m);
    if (u == null) {
      return null;
    }
    double[] y = solver.target.clone();
    for (int i = 0; i < k; i++) {
      for (int c = 0; c < d; c++) {
        y[c] += u[i] * solver.a[rows[i] * d + c];
      }
    }
    return y;
  }

  private static double[] eliminate(double[][] m) {
    int k = m.length;
    for (int i = 0; i < k; i++) {
      int pivot = i;
      for (int r = i + 1; r < k; r++) {
        pivot = Math.abs(m[r][i]) > Math.abs(m[pivot][i]) ? r : pivot;
      }
      double[] spare = m[i];
      m[i] = m[pivot];
      m[pivot] = spare;
      if (Math.abs(m[i][i]) < 1e-10) {
        return null;
      }
      for (int r = 0; r < k; r++) {
        double f = r == i ? 0 : m[r][i] / m[i][i];
        for (int c = i; c <= k; c++) {
          m[r][c] -= f * m[i][c];
        }
      }
    }
    double[] x = new double[k];
    for (int i = 0; i < k; i++) {
      x[i] = m[i][k] / m[i][i];
    }
    return x;
  }
}
