package org.palpate.benchmarks.jitter.experiment;

/** What runs once a millisecond. */
public enum Workload {
  /** Nothing: the paper's simplest Java application. */
  EMPTY("empty"),
  /** One haptic frame on the scene, with the simulated device. */
  FRAME("frame"),
  /** The same, with the view drawn beside it, off screen. */
  FRAME_AND_VIEW("view");

  private final String label;

  Workload(String label) {
    this.label = label;
  }

  public String label() {
    return label;
  }
}
