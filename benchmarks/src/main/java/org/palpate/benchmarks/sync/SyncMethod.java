package org.palpate.benchmarks.sync;

/** How the haptic thread changes the scene. */
enum SyncMethod {
  /** Not at all: the control. */
  NONE("no scene"),
  /** It changes the scene itself, and each change is drawn. */
  DIRECT("direct"),
  /** By the paper's synchronized accumulators. */
  PAPER("paper, synchronized"),
  /** By wait-free accumulators. */
  WAIT_FREE("wait-free");

  private final String title;

  SyncMethod(String title) {
    this.title = title;
  }

  String title() {
    return title;
  }
}
