package org.palpate.benchmarks.jitter.trace;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * From a flight recording's time to {@link System#nanoTime}: a line through the two tightest of the
 * pairs that the measured JVM noted, one early and one late, since both clocks drift apart by parts
 * in a million.
 */
final class ClockMap {
  private final long originRecording;
  private final long originNanos;
  private final double rate;

  private ClockMap(long originRecording, long originNanos, double rate) {
    this.originRecording = originRecording;
    this.originNanos = originNanos;
    this.rate = rate;
  }

  /**
   * One moment on both clocks.
   *
   * @param recordingNanos of the recording, since the epoch
   * @param before of {@code System.nanoTime}, just before
   * @param after of {@code System.nanoTime}, just after
   */
  record Pair(long recordingNanos, long before, long after) {
    long width() {
      return after - before;
    }

    long middle() {
      return before + width() / 2;
    }
  }

  /**
   * @param pairs at least one; the first half counts as early
   * @throws IllegalArgumentException where there is none
   */
  static ClockMap through(List<Pair> pairs) {
    if (pairs.isEmpty()) {
      throw new IllegalArgumentException("no pair of clocks to go by");
    }
    List<Pair> sorted = new ArrayList<>(pairs);
    sorted.sort(Comparator.comparingLong(Pair::recordingNanos));
    Pair early = tightest(sorted.subList(0, (sorted.size() + 1) / 2));
    Pair late = tightest(sorted.subList(sorted.size() / 2, sorted.size()));
    long apart = late.recordingNanos() - early.recordingNanos();
    double rate = apart > 0 ? (double) (late.middle() - early.middle()) / apart : 1;
    return new ClockMap(early.recordingNanos(), early.middle(), rate);
  }

  private static Pair tightest(List<Pair> pairs) {
    return pairs.stream().min(Comparator.comparingLong(Pair::width)).orElseThrow();
  }

  /** The moment on the clock of {@code System.nanoTime}. */
  long toNanoTime(long recordingNanos) {
    return originNanos + Math.round((recordingNanos - originRecording) * rate);
  }
}
