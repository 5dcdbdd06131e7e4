package org.palpate.statistics;

import java.util.Arrays;

/**
 * Percentiles of the counted work of frames, which no machine changes. The unit is that of the
 * solver. A percentile is the smallest work that this part of all frames did not exceed, so it is
 * the work of an actual frame.
 *
 * @param p50 median
 * @param p99 99th percentile
 * @param p999 99.9th percentile
 * @param max the most
 */
public record WorkPercentiles(long p50, long p99, long p999, long max) {
  /**
   * {@return the percentiles of some frames, or zeros for none}
   *
   * @param work of each frame; not changed
   */
  public static WorkPercentiles of(long[] work) {
    long[] sorted = work.clone();
    Arrays.sort(sorted);
    return new WorkPercentiles(
        quantile(sorted, 0.5),
        quantile(sorted, 0.99),
        quantile(sorted, 0.999),
        quantile(sorted, 1));
  }

  private static long quantile(long[] sorted, double fraction) {
    int rank = (int) Math.ceil(fraction * sorted.length);
    return sorted.length == 0 ? 0 : sorted[Math.max(0, rank - 1)];
  }
}
