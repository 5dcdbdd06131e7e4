package org.palpate.benchmarks.jitter.trace;

/**
 * Why a frame was late.
 *
 * @param kind the largest part of what is known
 * @param frame which frame, from 0
 * @param dueNanos when the frame should have begun, on the clock of {@link System#nanoTime}
 * @param latenessNanos how late it began
 * @param workNanos how long its work took
 * @param evidence what is known, in words and figures
 */
public record Cause(
    Kind kind, int frame, long dueNanos, long latenessNanos, long workNanos, String evidence) {

  /** How late the frame's force was out. */
  public long responseNanos() {
    return latenessNanos + workNanos;
  }

  /** Kinds of causes. */
  public enum Kind {
    /** The collector stopped the thread, or had its processor. */
    GC("GC"),
    /** The JVM stopped all threads for something else. */
    SAFEPOINT("safepoint"),
    /** The frame ran while its code was compiled, or the compiler had its processor. */
    JIT("JIT"),
    /** The frame's machine code was given up. */
    DEOPTIMIZATION("deoptimization"),
    /** The thread was ready and another one ran. */
    SCHEDULER("scheduler delay"),
    /** A page had to come from a disk. */
    PAGING("page fault"),
    /** The hypervisor gave the processor to another guest. */
    STEAL("steal"),
    /** Nothing of this is seen. */
    OUTSIDE("outside the JVM");

    private final String label;

    Kind(String label) {
      this.label = label;
    }

    /** As a person reads it. */
    public String label() {
      return label;
    }
  }
}
