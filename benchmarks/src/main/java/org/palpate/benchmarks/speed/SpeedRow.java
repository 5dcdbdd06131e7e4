package org.palpate.benchmarks.speed;

import java.util.List;
import java.util.Map;

/**
 * One benchmark under one condition.
 *
 * @param group which table it belongs to
 * @param name what was measured
 * @param params the condition, in the order in which it is told
 * @param unit of the times, for an operation
 * @param scores the time of each iteration, ascending
 * @param bytes allocated by an operation; NaN where that was not measured
 */
record SpeedRow(
    String group,
    String name,
    Map<String, String> params,
    String unit,
    List<Double> scores,
    double bytes) {

  /** Below this a benchmark's own frame is all that allocates. */
  private static final double NO_BYTES = 0.5;

  double median() {
    int half = scores.size() / 2;
    return scores.size() % 2 == 1
        ? scores.get(half)
        : (scores.get(half - 1) + scores.get(half)) / 2;
  }

  double least() {
    return scores.get(0);
  }

  double greatest() {
    return scores.get(scores.size() - 1);
  }

  /** Whether an operation allocates nothing. */
  boolean allocatesNothing() {
    return bytes < NO_BYTES;
  }

  String condition() {
    return String.join(", ", params.values());
  }
}
