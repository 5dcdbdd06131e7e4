package org.palpate.benchmarks.jitter.trace;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Maps a flight recording's time to {@link System#nanoTime}. The map is a line through two pairs of
 * readings, the narrowest early one and the narrowest late one, because the clocks drift apart by
 * parts in a million.
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
   * A moment on both clocks.
   *
   * @param recordingNanos the recording's time since the epoch
   * @param before {@code System.nanoTime} just before
   * @param after {@code System.nanoTime} just after
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
   * Returns the map through some pairs.
   *
   * @param pairs at least one; the first half counts as early
   * @throws IllegalArgumentException if there is none
   */
  static ClockMap through(List<Pair> pairs) {
    if (pairs.isEmpty()) {
      throw new IllegalArgumentException("no pair of clock readings");
    }
    List<Pair> sorted = new ArrayList<>(pairs);
    sorted.sort(Comparator.comparingLong(Pair::recordingNanos));
    Pair early = narrowest(sorted.subList(0, (sorted.size() + 1) / 2));
    Pair late = narrowest(sorted.subList(sorted.size() / 2, sorted.size()));
    long apart = late.recordingNanos() - early.recordingNanos();
    double rate = apart > 0 ? (double) (late.middle() - early.middle()) / apart : 1;
    return new ClockMap(early.recordingNanos(), early.middle(), rate);
  }

  private static Pair narrowest(List<Pair> pairs) {
    return pairs.stream().min(Comparator.comparingLong(Pair::width)).orElseThrow();
  }

  /** Converts a time of the recording to the clock of {@code System.nanoTime}. */
  long toNanoTime(long recordingNanos) {
    return originNanos + Math.round((recordingNanos - originRecording) * rate);
  }
}
