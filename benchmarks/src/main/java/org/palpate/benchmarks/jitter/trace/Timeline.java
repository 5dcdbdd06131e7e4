package org.palpate.benchmarks.jitter.trace;

import java.util.ArrayList;
import java.util.List;

/**
 * The latest force in each of several equal stretches of an experiment, for a plot.
 *
 * @param seconds the middle of each stretch, from the first frame's deadline
 * @param worstMicros the time from the deadline to the latest force of each stretch
 */
public record Timeline(List<Double> seconds, List<Double> worstMicros) {
  private static final double NANOS_PER_SECOND = 1e9;
  private static final double NANOS_PER_MICRO = 1e3;

  /**
   * Divides the samples into stretches of equal length.
   *
   * @param stretches the largest number of stretches
   */
  public static Timeline of(Samples samples, int stretches) {
    int count = Math.min(stretches, samples.count());
    List<Double> seconds = new ArrayList<>();
    List<Double> worst = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      int first = Math.toIntExact((long) samples.count() * i / count);
      int next = Math.toIntExact((long) samples.count() * (i + 1) / count);
      seconds.add((samples.due((first + next) / 2) - samples.due(0)) / NANOS_PER_SECOND);
      worst.add(worstNanos(samples, first, next) / NANOS_PER_MICRO);
    }
    return new Timeline(seconds, worst);
  }

  private static double worstNanos(Samples samples, int first, int next) {
    long worst = 0;
    for (int frame = first; frame < next; frame++) {
      worst = Math.max(worst, samples.response(frame));
    }
    return worst;
  }
}
