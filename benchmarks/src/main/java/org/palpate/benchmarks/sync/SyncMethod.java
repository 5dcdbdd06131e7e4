package org.palpate.benchmarks.sync;

/** Methods by which the haptic thread changes the scene. */
enum SyncMethod {
  /** No changes: the control. */
  NONE("no scene"),
  /** Direct changes, each of which is drawn. */
  DIRECT("direct"),
  /** The paper's synchronized accumulators. */
  PAPER("paper, synchronized"),
  /** Wait-free accumulators. */
  WAIT_FREE("wait-free");

  private final String title;

  SyncMethod(String title) {
    this.title = title;
  }

  /** Returns the name in tables. */
  String title() {
    return title;
  }
}
