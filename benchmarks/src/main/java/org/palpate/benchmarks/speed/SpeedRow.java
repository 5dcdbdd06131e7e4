package org.palpate.benchmarks.speed;

import java.util.List;
import java.util.Map;
import org.palpate.loop.Median;

/**
 * The result of one benchmark under one condition.
 *
 * @param group the table that it belongs to
 * @param name the benchmark
 * @param params the condition, in the order of the report
 * @param unit the unit of the scores
 * @param scores the time of an operation in each iteration, ascending
 * @param bytes the bytes allocated per operation; NaN if not measured
 */
record SpeedRow(
    String group,
    String name,
    Map<String, String> params,
    String unit,
    List<Double> scores,
    double bytes) {

  /** Below this, only the benchmark's own frame allocates. */
  private static final double NO_BYTES = 0.5;

  /** Returns the median score. */
  double median() {
    return Median.of(scores.stream().mapToDouble(Double::doubleValue).toArray());
  }

  /** Returns the smallest score. */
  double least() {
    return scores.get(0);
  }

  /** Returns the largest score. */
  double greatest() {
    return scores.get(scores.size() - 1);
  }

  /** Whether an operation allocates nothing. */
  boolean allocatesNothing() {
    return bytes < NO_BYTES;
  }

  /** Returns the values of the condition as text. */
  String condition() {
    return String.join(", ", params.values());
  }

  /** Returns the cells of its row in the table. */
  List<Object> cells() {
    return List.of(
        group,
        name,
        condition(),
        unit,
        median(),
        least(),
        greatest(),
        scores.size(),
        Double.isNaN(bytes) ? "" : bytes);
  }
}
