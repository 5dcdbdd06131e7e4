package org.palpate.rigid;

import java.util.Arrays;

/**
 * Finds the point nearest to a target in a few dimensions subject to linear inequalities: minimizes
 * |y - target|^2 subject to a_i . y >= b_i. The dual active-set method: starts at the target and
 * adds the constraint that is violated most, dropping others whose multipliers would turn negative.
 *
 * <p>Reference: Goldfarb and Idnani, A numerically stable dual method for solving strictly convex
 * quadratic programs, 1983, here with the identity as Hessian.
 *
 * <p>Belongs to one thread; allocates nothing after construction.
 */
final class NearestPointSolver {
  /** A constraint counts as met if it is violated by no more than this, in the unit of y. */
  static final double TOLERANCE = 1e-9;

  /** A row counts as dependent on the active ones below this square of its sine to their span. */
  private static final double DEPENDENT = 1e-12;

  private static final int MOST_ITERATIONS = 100;

  final int dimension;

  /**
   * The rows of the constraints, {@link #dimension} entries each; the first {@link #rows} count.
   */
  final double[] a;

  final double[] b;
  final double[] target;

  /** The solution. */
  final double[] y;

  /** The rows that are met with equality at the solution. */
  final int[] active;

  final double[] multiplier;
  int rows;
  int activeCount;

  private final double[] coefficient;
  private final double[] part;
  private final double[] direction;
  private final double[] factor;
  private int iterations;

  NearestPointSolver(int dimension, int mostRows) {
    this.dimension = dimension;
    a = new double[dimension * mostRows];
    b = new double[mostRows];
    target = new double[dimension];
    y = new double[dimension];
    active = new int[dimension + 1];
    multiplier = new double[dimension + 1];
    coefficient = new double[dimension];
    part = new double[dimension];
    direction = new double[dimension];
    factor = new double[dimension * dimension];
  }

  /**
   * Solves; returns false if the constraints contradict each other or rounding prevents an answer.
   */
  boolean solve() {
    System.arraycopy(target, 0, y, 0, dimension);
    activeCount = 0;
    iterations = 0;
    for (int worst = mostViolated(); worst >= 0; worst = mostViolated()) {
      if (!activate(worst)) {
        return false;
      }
    }
    return true;
  }

  private int mostViolated() {
    int worst = -1;
    double least = -TOLERANCE;
    for (int row = 0; row < rows; row++) {
      double slack = along(row) - b[row];
      if (slack < least) {
        least = slack;
        worst = row;
      }
    }
    return worst;
  }

  /** Returns a_row . y. */
  double along(int row) {
    double sum = 0;
    int at = row * dimension;
    for (int c = 0; c < dimension; c++) {
      sum += a[at + c] * y[c];
    }
    return sum;
  }

  /** Makes a row active; drops active rows whose multipliers would turn negative. */
  private boolean activate(int row) {
    double own = 0;
    while (iterations++ < MOST_ITERATIONS) {
      project(row);
      int blocking = firstToVanish();
      double partial =
          blocking < 0 ? Double.POSITIVE_INFINITY : multiplier[blocking] / coefficient[blocking];
      double full = fullStep(row);
      double step = Math.min(partial, full);
      if (step == Double.POSITIVE_INFINITY) {
        return false;
      }
      advance(step, full < Double.POSITIVE_INFINITY);
      own += step;
      if (step == full) {
        active[activeCount] = row;
        multiplier[activeCount++] = own;
        return true;
      }
      drop(blocking);
    }
    return false;
  }

  /**
   * Splits a row into its part in the span of the active rows and the direction orthogonal to it.
   * Projects twice, because rounding leaves some of the span in the direction the first time.
   */
  private void project(int row) {
    System.arraycopy(a, row * dimension, direction, 0, dimension);
    factorize();
    Arrays.fill(coefficient, 0, activeCount, 0);
    removeSpan();
    removeSpan();
  }

  /** Factorizes N^T N by Cholesky, where N holds the active rows. */
  private void factorize() {
    for (int i = 0; i < activeCount; i++) {
      for (int j = 0; j <= i; j++) {
        double v = dot(active[i], active[j]);
        for (int c = 0; c < j; c++) {
          v -= factor[i * dimension + c] * factor[j * dimension + c];
        }
        factor[i * dimension + j] =
            i == j ? Math.sqrt(Math.max(v, Double.MIN_NORMAL)) : v / factor[j * dimension + j];
      }
    }
  }

  /** Subtracts the part in the span of the active rows from the direction. */
  private void removeSpan() {
    for (int i = 0; i < activeCount; i++) {
      double v = 0;
      for (int c = 0; c < dimension; c++) {
        v += a[active[i] * dimension + c] * direction[c];
      }
      for (int c = 0; c < i; c++) {
        v -= factor[i * dimension + c] * part[c];
      }
      part[i] = v / factor[i * dimension + i];
    }
    for (int i = activeCount - 1; i >= 0; i--) {
      double v = part[i];
      for (int c = i + 1; c < activeCount; c++) {
        v -= factor[c * dimension + i] * part[c];
      }
      part[i] = v / factor[i * dimension + i];
    }
    for (int j = 0; j < activeCount; j++) {
      coefficient[j] += part[j];
      for (int c = 0; c < dimension; c++) {
        direction[c] -= part[j] * a[active[j] * dimension + c];
      }
    }
  }

  private double dot(int rowA, int rowB) {
    double sum = 0;
    for (int c = 0; c < dimension; c++) {
      sum += a[rowA * dimension + c] * a[rowB * dimension + c];
    }
    return sum;
  }

  /** Returns the active row whose multiplier vanishes first; -1 if none does. */
  private int firstToVanish() {
    int first = -1;
    double least = Double.POSITIVE_INFINITY;
    for (int j = 0; j < activeCount; j++) {
      if (coefficient[j] > 1e-12 && multiplier[j] / coefficient[j] < least) {
        least = multiplier[j] / coefficient[j];
        first = j;
      }
    }
    return first;
  }

  /** Returns the step after which the row is met; infinite if it depends on the active rows. */
  private double fullStep(int row) {
    double square = 0;
    for (int c = 0; c < dimension; c++) {
      square += direction[c] * direction[c];
    }
    boolean independent = square > DEPENDENT * dot(row, row) && activeCount < dimension;
    return independent ? (b[row] - along(row)) / square : Double.POSITIVE_INFINITY;
  }

  private void advance(double step, boolean moves) {
    for (int c = 0; moves && c < dimension; c++) {
      y[c] += step * direction[c];
    }
    for (int j = 0; j < activeCount; j++) {
      multiplier[j] = Math.max(0, multiplier[j] - step * coefficient[j]);
    }
  }

  private void drop(int index) {
    activeCount--;
    for (int j = index; j < activeCount; j++) {
      active[j] = active[j + 1];
      multiplier[j] = multiplier[j + 1];
    }
  }
}
