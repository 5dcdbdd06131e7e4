package org.palpate.benchmarks.jitter.experiment;

/** Kinds of scheduling of the measured thread. */
public enum Scheduling {
  /** An ordinary thread. */
  NORMAL("normal"),
  /** SCHED_FIFO, a processor of its own, locked memory. */
  FIFO("fifo"),
  /**
   * As {@link #FIFO}. The threads of the JVM that the measured thread waits for during a pause are
   * in SCHED_FIFO too, one priority below.
   */
  FIFO_WITH_VM("fifovm");

  private final String label;

  Scheduling(String label) {
    this.label = label;
  }

  /** Whether the thread runs before all ordinary threads. */
  public boolean isRealtime() {
    return this != NORMAL;
  }

  /** Returns the word for a table. */
  public String label() {
    return label;
  }
}
