package org.palpate.loop;

import org.HdrHistogram.AbstractHistogram;

/**
 * Quantiles of a set of durations, microseconds; zeros without any duration.
 *
 * @param p50 median
 * @param p99 99th percentile
 * @param p999 99.9th percentile
 * @param max the longest
 */
public record Quantiles(double p50, double p99, double p999, double max) {
  private static final double NANOS_PER_MICRO = 1e3;

  /** Returns the quantiles of a histogram of nanoseconds. */
  static Quantiles of(AbstractHistogram nanos) {
    return new Quantiles(
        nanos.getValueAtPercentile(50) / NANOS_PER_MICRO,
        nanos.getValueAtPercentile(99) / NANOS_PER_MICRO,
        nanos.getValueAtPercentile(99.9) / NANOS_PER_MICRO,
        nanos.getMaxValue() / NANOS_PER_MICRO);
  }
}
