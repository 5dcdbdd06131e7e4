package org.palpate.benchmarks.jitter;

/** What a cell runs once a period. Belongs to the measured thread, but for {@link #close}. */
interface CellFrame extends Runnable, AutoCloseable {
  /** Makes the frame of a workload. */
  static CellFrame of(CellTask task) {
    return switch (task.workload()) {
      case EMPTY -> () -> {};
      default -> throw new IllegalArgumentException("no such frame: " + task.workload());
    };
  }

  @Override
  default void close() {}
}
