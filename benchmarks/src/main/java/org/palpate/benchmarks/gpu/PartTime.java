package org.palpate.benchmarks.gpu;

import java.util.List;
import org.HdrHistogram.Histogram;

/**
 * The time that a part of a batch takes.
 *
 * @param device the name of the device
 * @param points the number of legs
 * @param part what was timed
 * @param frames how often
 * @param least the shortest, us
 * @param p50 the median, us
 * @param p99 the 99th percentile, us
 * @param p999 the 99.9th percentile, us
 * @param max the longest, us
 */
record PartTime(
    String device,
    int points,
    String part,
    int frames,
    double least,
    double p50,
    double p99,
    double p999,
    double max) {
  private static final double NANOS_PER_MICRO = 1e3;
  private static final int SIGNIFICANT_DIGITS = 3;

  /** Runs a part often, after a warm-up of a tenth of that, and returns its times. */
  static PartTime measure(String device, int points, String part, int frames, Runnable run) {
    for (int n = 0; n < frames / 10 + 1; n++) {
      run.run();
    }
    Histogram nanos = new Histogram(SIGNIFICANT_DIGITS);
    for (int n = 0; n < frames; n++) {
      long start = System.nanoTime();
      run.run();
      nanos.recordValue(System.nanoTime() - start);
    }
    return new PartTime(
        device,
        points,
        part,
        frames,
        nanos.getMinValue() / NANOS_PER_MICRO,
        nanos.getValueAtPercentile(50) / NANOS_PER_MICRO,
        nanos.getValueAtPercentile(99) / NANOS_PER_MICRO,
        nanos.getValueAtPercentile(99.9) / NANOS_PER_MICRO,
        nanos.getMaxValue() / NANOS_PER_MICRO);
  }

  List<Object> cells() {
    return List.of(device, (long) points, part, (long) frames, least, p50, p99, p999, max);
  }
}
