package org.palpate.benchmarks.jitter.experiment;

import java.util.Properties;
import org.palpate.realtime.WaitKind;

/**
 * What the process of a cell needs to know of it.
 *
 * @param waiting how the loop waits
 * @param scheduling how its thread competes
 * @param workload what a frame does
 * @param neighbour what else the JVM does
 * @param frames how many are measured
 * @param periodNanos how far frames lie apart
 * @param scene what is touched; see {@link ExperimentScene}
 * @param training whether the run is for an archive of classes alone
 */
record ExperimentTask(
    WaitKind waiting,
    Scheduling scheduling,
    Workload workload,
    BackgroundLoad neighbour,
    int frames,
    long periodNanos,
    String scene,
    boolean training) {

  Properties toProperties() {
    Properties values = new Properties();
    values.setProperty("wait", waiting.name());
    values.setProperty("scheduling", scheduling.name());
    values.setProperty("workload", workload.name());
    values.setProperty("neighbour", neighbour.name());
    values.setProperty("frames", Integer.toString(frames));
    values.setProperty("period_nanos", Long.toString(periodNanos));
    values.setProperty("scene", scene);
    values.setProperty("training", Boolean.toString(training));
    return values;
  }

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

  ExperimentTask withFrames(int otherFrames) {
    return new ExperimentTask(
        waiting, scheduling, workload, neighbour, otherFrames, periodNanos, scene, training);
  }
}
