package org.palpate.loop;

import org.HdrHistogram.AbstractHistogram;

/**
 * What a report tells of a histogram of times, microseconds; zeros where nothing was recorded.
 *
 * @param p50 median
 * @param p99 99 of 100 are no longer
 * @param p999 999 of 1000 are no longer
 * @param max the longest
 */
public record Quantiles(double p50, double p99, double p999, double max) {
  private static final double NANOS_PER_MICRO = 1e3;

  /** From a histogram of nanoseconds. */
  static Quantiles of(AbstractHistogram nanos) {
    return new Quantiles(
        nanos.getValueAtPercentile(50) / NANOS_PER_MICRO,
        nanos.getValueAtPercentile(99) / NANOS_PER_MICRO,
        nanos.getValueAtPercentile(99.9) / NANOS_PER_MICRO,
        nanos.getMaxValue() / NANOS_PER_MICRO);
  }
}
