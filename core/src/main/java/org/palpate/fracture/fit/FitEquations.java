package org.palpate.fracture.fit;

import org.palpate.geometry.Vec3;

/**
 * The normal equations of a fit: six unknowns, a displacement in mm and a rotation times a lever in
 * mm, from distances between facing points. If the width of the gap is unknown, it is a seventh
 * unknown, which is eliminated. One thread an instance.
 *
 * <p>The equations determine some directions well and others hardly or not at all. A direction
 * counts by a factor that falls with its standard deviation, so noise moves nothing.
 */
final class FitEquations {
  /** Displacement and rotation. */
  static final int UNKNOWNS = 6;

  /** The standard deviation of a direction that counts one half, mm. */
  private static final double HALF_COUNTED_MM = 0.3;

  /** A direction in which distances change less counts as undetermined, mean square. */
  private static final double LEAST_SHARE = 1e-6;

  private final double leverMm;
  private final boolean isGapKnown;
  private final double[][] matrix = new double[UNKNOWNS][UNKNOWNS];
  private final double[] right = new double[UNKNOWNS];
  private final double[] mean = new double[UNKNOWNS];
  private final double[] row = new double[UNKNOWNS];
  private final double[] step = new double[UNKNOWNS];
  private final double[] pull = new double[UNKNOWNS * UNKNOWNS];
  private final Vec3 moment = new Vec3();
  private double residuals;
  private double squares;
  private double weights;

  FitEquations(double leverMm, boolean isGapKnown) {
    this.leverMm = leverMm;
    this.isGapKnown = isGapKnown;
  }

  /**
   * Adds a pair of facing points.
   *
   * @param arm from the centre of rotation to the point that moves, mm
   * @param direction the direction in which the pair is measured, a unit vector
   * @param residualMm how far the point must go along it
   */
  void add(Vec3 arm, Vec3 direction, double residualMm, double weight) {
    arm.cross(direction, moment);
    for (int axis = 0; axis < 3; axis++) {
      row[axis] = direction.get(axis);
      row[3 + axis] = moment.get(axis) / leverMm;
    }
    for (int n = 0; n < UNKNOWNS; n++) {
      for (int m = 0; m < UNKNOWNS; m++) {
        matrix[n][m] += weight * row[n] * row[m];
      }
      right[n] += weight * residualMm * row[n];
      mean[n] += weight * row[n];
    }
    residuals += weight * residualMm;
    squares += weight * residualMm * residualMm;
    weights += weight;
  }

  /**
   * Solves the equations, once.
   *
   * @param samples the number of distances that are independent of each other
   * @param leastNoiseMm the least standard deviation of a distance that is believed
   */
  void solve(double samples, double leastNoiseMm) {
    double variance = squares / weights;
    for (int n = 0; n < UNKNOWNS; n++) {
      right[n] /= weights;
      mean[n] /= weights;
    }
    double gap = isGapKnown ? 0 : residuals / weights;
    variance -= gap * gap;
    for (int n = 0; n < UNKNOWNS; n++) {
      right[n] -= gap * mean[n];
      for (int m = 0; m < UNKNOWNS; m++) {
        matrix[n][m] = matrix[n][m] / weights - (isGapKnown ? 0 : mean[n] * mean[m]);
      }
    }
    SymmetricEigen eigen = new SymmetricEigen(matrix);
    double left = variance;
    for (int n = 0; n < UNKNOWNS; n++) {
      double along = along(eigen, n);
      left -= eigen.value(n) > LEAST_SHARE ? along * along / eigen.value(n) : 0;
    }
    double noise = Math.max(left, leastNoiseMm * leastNoiseMm) / Math.max(1, samples);
    for (int n = 0; n < UNKNOWNS; n++) {
      if (eigen.value(n) > LEAST_SHARE) {
        addDirection(eigen, n, noise);
      }
    }
  }

  /** Returns the right-hand side along an eigenvector. */
  private double along(SymmetricEigen eigen, int n) {
    double along = 0;
    for (int m = 0; m < UNKNOWNS; m++) {
      along += eigen.component(n, m) * right[m];
    }
    return along;
  }

  private void addDirection(SymmetricEigen eigen, int n, double noise) {
    double value = eigen.value(n);
    double factor = 1 / (1 + noise / value / (HALF_COUNTED_MM * HALF_COUNTED_MM));
    double length = factor * along(eigen, n) / value;
    for (int m = 0; m < UNKNOWNS; m++) {
      step[m] += length * eigen.component(n, m);
      for (int l = 0; l < UNKNOWNS; l++) {
        pull[UNKNOWNS * m + l] += factor * eigen.component(n, m) * eigen.component(n, l);
      }
    }
  }

  /** Returns the motion that fits best: displacement and rotation times the lever, mm. */
  double[] step() {
    return step;
  }

  /**
   * Returns a symmetric matrix, row by row: it keeps the directions that the equations determine
   * and shortens the others.
   */
  double[] pull() {
    return pull;
  }
}
