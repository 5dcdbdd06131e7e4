package org.palpate.benchmarks.jitter.experiment;

import java.util.Properties;
import org.palpate.realtime.WaitKind;

/**
 * The part of an experiment that its process needs, saved as properties.
 *
 * @param waiting the loop's wait for its next frame
 * @param scheduling the scheduling of its thread
 * @param workload the work of a frame
 * @param load the background load in the JVM
 * @param frames the number of measured frames
 * @param periodNanos the time between two deadlines
 * @param scene the touched scene; see {@link ExperimentScene}
 * @param training whether the run only makes an archive of classes
 */
record ExperimentTask(
    WaitKind waiting,
    Scheduling scheduling,
    Workload workload,
    BackgroundLoad load,
    int frames,
    long periodNanos,
    String scene,
    boolean training) {

  /** Returns the task as properties. */
  Properties toProperties() {
    Properties values = new Properties();
    values.setProperty("wait", waiting.name());
    values.setProperty("scheduling", scheduling.name());
    values.setProperty("workload", workload.name());
    values.setProperty("neighbour", load.name());
    values.setProperty("frames", Integer.toString(frames));
    values.setProperty("period_nanos", Long.toString(periodNanos));
    values.setProperty("scene", scene);
    values.setProperty("training", Boolean.toString(training));
    return values;
  }

  /** Parses the properties of a task. */
  static ExperimentTask of(Properties values) {
    return new ExperimentTask(
        WaitKind.valueOf(values.getProperty("wait")),
        Scheduling.valueOf(values.getProperty("scheduling")),
        Workload.valueOf(values.getProperty("workload")),
        BackgroundLoad.valueOf(values.getProperty("neighbour")),
        Integer.parseInt(values.getProperty("frames")),
        Long.parseLong(values.getProperty("period_nanos")),
        values.getProperty("scene"),
        Boolean.parseBoolean(values.getProperty("training")));
  }
}
