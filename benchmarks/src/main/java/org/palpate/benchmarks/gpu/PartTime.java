package org.palpate.benchmarks.gpu;

import java.util.Arrays;
import java.util.List;

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

  /** Runs a part often, after a warm-up of a tenth of that, and returns its times. */
  static PartTime measure(String device, int points, String part, int frames, Runnable run) {
    for (int n = 0; n < frames / 10 + 1; n++) {
      run.run();
    }
    long[] nanos = new long[frames];
    for (int n = 0; n < frames; n++) {
      long start = System.nanoTime();
      run.run();
      nanos[n] = System.nanoTime() - start;
    }
    Arrays.sort(nanos);
    return new PartTime(
        device,
        points,
        part,
        frames,
        micros(nanos, 0),
        micros(nanos, 0.5),
        micros(nanos, 0.99),
        micros(nanos, 0.999),
        micros(nanos, 1));
  }

  private static double micros(long[] sortedNanos, double part) {
    int index = (int) Math.min(sortedNanos.length - 1.0, part * sortedNanos.length);
    return sortedNanos[index] / NANOS_PER_MICRO;
  }

  List<Object> cells() {
    return List.of(device, (long) points, part, (long) frames, least, p50, p99, p999, max);
  }
}
