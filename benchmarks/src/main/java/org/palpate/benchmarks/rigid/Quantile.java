package org.palpate.benchmarks.rigid;

import java.util.Arrays;

/** Computes quantiles of measured values. */
public final class Quantile {
  private Quantile() {}

  /**
   * Returns the value below which a part of the values lies.
   *
   * @param part from 0, the least value, to 1, the largest
   * @throws IllegalArgumentException if there is no value
   */
  public static double of(double[] values, double part) {
    if (values.length == 0) {
      throw new IllegalArgumentException("no values to take a quantile of");
    }
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted[(int) Math.min(sorted.length - 1.0, part * sorted.length)];
  }
}
