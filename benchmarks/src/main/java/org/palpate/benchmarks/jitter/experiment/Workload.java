package org.palpate.benchmarks.jitter.experiment;

/** Workloads of one period. */
public enum Workload {
  /** No work: the paper's simplest Java application. */
  EMPTY("empty"),
  /** One haptic frame with the simulated device. */
  FRAME("frame"),
  /** As {@link #FRAME}, with a view that another thread draws off screen. */
  FRAME_AND_VIEW("view");

  private final String label;

  Workload(String label) {
    this.label = label;
  }

  /** Returns the word for a table. */
  public String label() {
    return label;
  }
}
