package org.palpate.benchmarks.jitter.trace;

/**
 * The cause of a late frame.
 *
 * @param kind the largest known part of the delay
 * @param frame the number of the frame, from 0
 * @param dueNanos the deadline of the frame, on the clock of {@link System#nanoTime}
 * @param latenessNanos the time from the deadline to the start of the frame
 * @param workNanos the duration of the frame's work
 * @param evidence all known parts of the delay, as text
 */
public record Cause(
    Kind kind, int frame, long dueNanos, long latenessNanos, long workNanos, String evidence) {

  /** Returns the time from the deadline to the frame's force. */
  public long responseNanos() {
    return latenessNanos + workNanos;
  }

  /** Kinds of causes. */
  public enum Kind {
    /** The collector stopped the thread or used its processor. */
    GC("GC"),
    /** The JVM stopped all threads for another reason. */
    SAFEPOINT("safepoint"),
    /** The frame ran interpreted during its compilation, or the compiler used its processor. */
    JIT("JIT"),
    /** The frame's machine code was discarded. */
    DEOPTIMIZATION("deoptimization"),
    /** The thread was ready, but another one ran. */
    SCHEDULER("scheduler delay"),
    /** A page was read from a disk. */
    PAGING("page fault"),
    /** The hypervisor gave the processor to another guest. */
    STEAL("steal"),
    /** None of these was observed. */
    OUTSIDE("outside the JVM");

    private final String label;

    Kind(String label) {
      this.label = label;
    }

    /** Returns the words for a report. */
    public String label() {
      return label;
    }
  }
}
