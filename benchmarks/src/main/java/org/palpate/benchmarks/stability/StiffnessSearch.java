package org.palpate.benchmarks.stability;

import java.util.function.DoubleFunction;
import org.palpate.benchmarks.stability.ClosedLoop.Outcome;

/**
 * Finds the largest stable stiffness of a trial. It doubles a soft start until the handle vibrates,
 * then bisects the interval on a logarithmic scale.
 */
final class StiffnessSearch {
  /** The start of the search, N/m. */
  static final double SOFTEST = 50;

  /** The end of the search, N/m; no device renders more. */
  static final double STIFFEST = 200_000;

  /** Five bisections of a factor of 2, to 2 %. */
  private static final int HALVINGS = 5;

  private StiffnessSearch() {}

  /**
   * Returns the largest stable stiffness, N/m; 0 if the softest is unstable, infinity if the
   * stiffest is stable.
   *
   * @param trial runs with a stiffness, N/m
   */
  static double largest(DoubleFunction<Outcome> trial) {
    double stable = 0;
    double unstable = SOFTEST;
    while (trial.apply(unstable).stable()) {
      if (unstable == STIFFEST) {
        return Double.POSITIVE_INFINITY;
      }
      stable = unstable;
      unstable = Math.min(2 * unstable, STIFFEST);
    }
    return stable == 0 ? 0 : between(trial, stable, unstable);
  }

  private static double between(DoubleFunction<Outcome> trial, double low, double high) {
    double stable = low;
    double unstable = high;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = Math.sqrt(stable * unstable);
      if (trial.apply(middle).stable()) {
        stable = middle;
      } else {
        unstable = middle;
      }
    }
    return stable;
  }
}
