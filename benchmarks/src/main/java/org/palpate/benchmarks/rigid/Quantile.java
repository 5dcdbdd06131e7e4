package org.palpate.benchmarks.rigid;

import java.util.Arrays;

/** Computes quantiles of measured values. */
final class Quantile {
  private Quantile() {}

  /**
   * Returns the value below which a part of the values lies.
   *
   * @param part from 0, the least value, to 1, the largest
   * @return 0 if there is no value
   */
  static double of(double[] values, double part) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted.length == 0
        ? 0
        : sorted[(int) Math.min(sorted.length - 1.0, part * sorted.length)];
  }
}
