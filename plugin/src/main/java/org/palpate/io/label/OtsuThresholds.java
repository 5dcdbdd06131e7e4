package org.palpate.io.label;

import java.util.List;

/**
 * Computes the two thresholds that split a histogram into three classes of least variance.
 *
 * <p>Source: N. Otsu, "A threshold selection method from gray-level histograms", 1979, section IV.
 */
final class OtsuThresholds {
  /** The number of groups of neighbouring values between which thresholds are sought. */
  private static final int GROUPS = 256;

  private OtsuThresholds() {}

  /**
   * Returns the thresholds.
   *
   * @param histogram pairs of value and count, ascending by value
   * @return two ascending values, each the least of its class; empty if there are fewer than three
   *     values
   */
  static List<Double> of(List<double[]> histogram) {
    if (histogram.size() < 3) {
      return List.of();
    }
    double[][] groups = group(histogram);
    double[] count = new double[groups.length + 1];
    double[] sum = new double[groups.length + 1];
    for (int n = 0; n < groups.length; n++) {
      count[n + 1] = count[n] + groups[n][1];
      sum[n + 1] = sum[n] + groups[n][2];
    }
    double best = -1;
    int first = 1;
    int second = 2;
    for (int a = 1; a < groups.length - 1; a++) {
      for (int b = a + 1; b < groups.length; b++) {
        double between =
            betweenVariance(count, sum, 0, a)
                + betweenVariance(count, sum, a, b)
                + betweenVariance(count, sum, b, groups.length);
        if (between > best) {
          best = between;
          first = a;
          second = b;
        }
      }
    }
    return List.of(groups[first][0], groups[second][0]);
  }

  /**
   * Returns the squared sum over the count of the groups from {@code from} to before {@code to}.
   */
  private static double betweenVariance(double[] count, double[] sum, int from, int to) {
    double n = count[to] - count[from];
    double s = sum[to] - sum[from];
    return n > 0 ? s * s / n : 0;
  }

  /** Returns least value, count and sum for at most {@link #GROUPS} equal ranges of values. */
  private static double[][] group(List<double[]> histogram) {
    double low = histogram.get(0)[0];
    double high = histogram.get(histogram.size() - 1)[0];
    int groups = Math.min(GROUPS, histogram.size());
    double[][] result = new double[groups][3];
    for (int n = 0; n < groups; n++) {
      result[n][0] = low + (high - low) * n / groups;
    }
    for (double[] entry : histogram) {
      int n = (int) Math.min(groups - 1, (entry[0] - low) / (high - low) * groups);
      result[n][1] += entry[1];
      result[n][2] += entry[1] * (entry[0] - low);
    }
    return result;
  }
}
