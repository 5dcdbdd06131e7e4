package org.palpate.benchmarks.jitter;

/** How the measured thread competes. */
enum Scheduling {
  /** As any thread. */
  NORMAL("normal"),
  /** SCHED_FIFO, one processor of its own, memory locked. */
  FIFO("fifo");

  private final String label;

  Scheduling(String label) {
    this.label = label;
  }

  String label() {
    return label;
  }
}
