package org.palpate.loop;

import java.util.Arrays;

/** Computes the median of measured values. */
public final class Median {
  private Median() {}

  /**
   * {@return the median; the mean of the two middle values if their number is even} Sorts a copy,
   * so it is not for the path of a frame.
   *
   * @param values at least one; not changed
   * @throws IllegalArgumentException if there is no value
   */
  public static double of(double... values) {
    if (values.length == 0) {
      throw new IllegalArgumentException("no values to take the median of");
    }
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    int middle = sorted.length / 2;
    return sorted.length % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
  }
}
