package org.palpate.benchmarks.sync;

import org.HdrHistogram.Histogram;

/**
 * What one way cost in one round.
 *
 * @param work of each frame, nanoseconds
 * @param period between the starts of two frames, nanoseconds
 * @param redraws pictures drawn
 * @param seconds that it took
 */
record SyncRow(
    SyncMethod way, int round, Histogram work, Histogram period, long redraws, double seconds) {

  double workMicros(double percentile) {
    return work.getValueAtPercentile(percentile) / 1e3;
  }

  double periodMicros(double percentile) {
    return period.getValueAtPercentile(percentile) / 1e3;
  }

  double rateHz() {
    return work.getTotalCount() / seconds;
  }
}
