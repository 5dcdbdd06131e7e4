package org.palpate.benchmarks.jitter.trace;

/**
 * Something that a JVM did, by its own flight recording.
 *
 * @param kind what
 * @param startNanos when it began, on the clock of {@link System#nanoTime}
 * @param endNanos when it ended; the same where it has no length
 * @param what its own name for it
 * @param inMeasuredThread whether the measured thread did it itself
 */
public record JvmEvent(
    Kind kind, long startNanos, long endNanos, String what, boolean inMeasuredThread) {

  /** Kinds of events. */
  public enum Kind {
    /** All Java threads stand still, for the collector. */
    GC_PAUSE,
    /** All Java threads stand still, for something else. */
    SAFEPOINT,
    /** A thread waits until the collector has memory for it. */
    ALLOCATION_STALL,
    /** A compiler thread makes machine code, beside the others. */
    COMPILATION,
    /** Machine code is given up and interpreted. */
    DEOPTIMIZATION,
    /** The collector works, beside the others. */
    GC_CONCURRENT
  }

  /** How long it and the stretch of time have in common. */
  long overlapNanos(long from, long to) {
    return Math.max(0, Math.min(endNanos, to) - Math.max(startNanos, from));
  }
}
