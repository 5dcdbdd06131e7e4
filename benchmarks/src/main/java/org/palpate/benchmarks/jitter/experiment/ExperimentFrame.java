package org.palpate.benchmarks.jitter.experiment;

import org.palpate.io.volume.VolumeFormatException;

/** What a cell runs once a period. Belongs to the measured thread, but for {@link #close}. */
interface ExperimentFrame extends Runnable, AutoCloseable {
  /** Makes the frame of a workload; the thread that calls does all that takes long. */
  static ExperimentFrame of(ExperimentTask task) throws VolumeFormatException {
    return switch (task.workload()) {
      case EMPTY -> () -> {};
      case FRAME -> new HapticExperimentFrame(ExperimentScene.read(task.scene()));
      case FRAME_AND_VIEW -> new ViewedExperimentFrame(ExperimentScene.read(task.scene()));
    };
  }

  @Override
  default void close() {}
}
