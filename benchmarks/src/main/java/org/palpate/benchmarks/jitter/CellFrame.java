package org.palpate.benchmarks.jitter;

import org.palpate.io.VolumeFormatException;

/** What a cell runs once a period. Belongs to the measured thread, but for {@link #close}. */
interface CellFrame extends Runnable, AutoCloseable {
  /** Makes the frame of a workload; the thread that calls does all that takes long. */
  static CellFrame of(CellTask task) throws VolumeFormatException {
    return switch (task.workload()) {
      case EMPTY -> () -> {};
      case FRAME -> new HapticCellFrame(CellScene.read(task.scene()));
      case FRAME_AND_VIEW -> new ViewedCellFrame(CellScene.read(task.scene()));
    };
  }

  @Override
  default void close() {}
}
