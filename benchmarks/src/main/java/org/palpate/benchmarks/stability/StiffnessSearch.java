package org.palpate.benchmarks.stability;

/**
 * Finds the largest stiffness up to which a trial comes to rest: doubles it from a soft start until
 * the handle shakes, then halves the interval on a logarithmic scale.
 */
final class StiffnessSearch {
  /** Where the search starts, N/m. */
  static final double SOFTEST = 50;

  /** Where it gives up: what no device renders, N/m. */
  static final double STIFFEST = 200_000;

  /** Five halvings of a factor of 2: to 2 %. */
  private static final int HALVINGS = 5;

  private StiffnessSearch() {}

  /**
   * The largest stiffness that rests, N/m: 0 where the softest shakes, infinity where the stiffest
   * does not.
   */
  static double largest(Trial trial) {
    double rests = 0;
    double shakes = SOFTEST;
    while (shakes <= STIFFEST && trial.run(shakes).rests()) {
      rests = shakes;
      shakes *= 2;
    }
    if (rests == 0) {
      return 0;
    }
    return shakes > STIFFEST ? Double.POSITIVE_INFINITY : between(trial, rests, shakes);
  }

  private static double between(Trial trial, double low, double high) {
    double rests = low;
    double shakes = high;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = Math.sqrt(rests * shakes);
      if (trial.run(middle).rests()) {
        rests = middle;
      } else {
        shakes = middle;
      }
    }
    return rests;
  }
}
