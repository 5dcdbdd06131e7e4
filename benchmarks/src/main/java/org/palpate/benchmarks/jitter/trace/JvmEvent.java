package org.palpate.benchmarks.jitter.trace;

/**
 * An event of a JVM, from its flight recording.
 *
 * @param kind the kind
 * @param startNanos the start, on the clock of {@link System#nanoTime}
 * @param endNanos the end; equal to the start if the event has no duration
 * @param what the JVM's name for it
 * @param inMeasuredThread whether it happened in the measured thread
 */
public record JvmEvent(
    Kind kind, long startNanos, long endNanos, String what, boolean inMeasuredThread) {

  /** Kinds of events. */
  public enum Kind {
    /** All Java threads are stopped for the collector. */
    GC_PAUSE,
    /** All Java threads are stopped for another reason. */
    SAFEPOINT,
    /** A thread waits until the collector has freed memory. */
    ALLOCATION_STALL,
    /** A compiler thread makes machine code while other threads run. */
    COMPILATION,
    /** Machine code is discarded and interpreted again. */
    DEOPTIMIZATION,
    /** The collector works while other threads run. */
    GC_CONCURRENT
  }

  /** Returns the time that the event shares with an interval. */
  long overlapNanos(long from, long to) {
    return Math.max(0, Math.min(endNanos, to) - Math.max(startNanos, from));
  }
}
