package org.palpate.benchmarks.jitter.experiment;

import org.palpate.io.volume.VolumeFormatException;

/** The work of one period. Belongs to the measured thread, except for {@link #close}. */
interface ExperimentFrame extends Runnable, AutoCloseable {
  /** Creates the frame of a workload; takes long, because it reads or makes the scene. */
  static ExperimentFrame of(ExperimentTask task) throws VolumeFormatException {
    return switch (task.workload()) {
      case EMPTY -> () -> {};
      case FRAME ->
          new HapticExperimentFrame(ExperimentScene.read(task.scene()), task.periodNanos());
      case FRAME_AND_VIEW ->
          new ViewedExperimentFrame(ExperimentScene.read(task.scene()), task.periodNanos());
    };
  }

  @Override
  default void close() {}
}
