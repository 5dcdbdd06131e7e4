package org.palpate.benchmarks.sync;

import java.util.List;
import org.HdrHistogram.Histogram;

/**
 * The cost of one method in one round.
 *
 * @param method the method
 * @param round the number of the round
 * @param work the work of each frame, ns
 * @param period the time between the starts of two frames, ns
 * @param redraws the number of pictures drawn
 * @param seconds the duration of the round
 */
record SyncRow(
    SyncMethod method, int round, Histogram work, Histogram period, long redraws, double seconds) {

  /** Returns a percentile of the work, microseconds. */
  double workMicros(double percentile) {
    return work.getValueAtPercentile(percentile) / 1e3;
  }

  /** Returns a percentile of the period, microseconds. */
  double periodMicros(double percentile) {
    return period.getValueAtPercentile(percentile) / 1e3;
  }

  /** Returns the number of frames per second. */
  double rateHz() {
    return work.getTotalCount() / seconds;
  }

  /** Returns the cells of its row in {@code sync.csv}. */
  List<Object> cells() {
    return List.of(
        method.title(),
        round,
        rateHz(),
        workMicros(50),
        workMicros(99),
        workMicros(99.9),
        workMicros(100),
        periodMicros(50),
        periodMicros(99),
        periodMicros(99.9),
        periodMicros(100),
        redraws);
  }
}
