package org.palpate.benchmarks.jitter.experiment;

/** How the measured thread competes. */
public enum Scheduling {
  /** As any thread. */
  NORMAL("normal"),
  /** SCHED_FIFO, one processor of its own, memory locked. */
  FIFO("fifo"),
  /** The same, and the JVM's own threads that a pause waits for one priority below. */
  FIFO_WITH_VM("fifovm");

  private final String label;

  Scheduling(String label) {
    this.label = label;
  }

  /** Whether the thread runs before all ordinary ones. */
  public boolean isRealtime() {
    return this != NORMAL;
  }

  public String label() {
    return label;
  }
}
