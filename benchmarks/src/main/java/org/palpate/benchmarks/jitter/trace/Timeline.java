package org.palpate.benchmarks.jitter.trace;

import java.util.ArrayList;
import java.util.List;

/**
 * The latest force out in each of some equal stretches of a cell, for a plot.
 *
 * @param seconds the middle of every stretch, from the first frame's deadline
 * @param worstMicros how late the latest force of the stretch was out
 */
public record Timeline(List<Double> seconds, List<Double> worstMicros) {
  private static final double NANOS_A_SECOND = 1e9;
  private static final double NANOS_A_MICRO = 1e3;

  /**
   * Divides the session into stretches of equal length and summarizes each.
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
      seconds.add((samples.due((first + next) / 2) - samples.due(0)) / NANOS_A_SECOND);
      worst.add(worstNanos(samples, first, next) / NANOS_A_MICRO);
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
