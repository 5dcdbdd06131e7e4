package org.palpate.benchmarks.jitter.experiment;

import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.Properties;
import jdk.jfr.Recording;
import org.palpate.benchmarks.jitter.trace.ClockPair;
import org.palpate.benchmarks.jitter.trace.ExperimentFolder;
import org.palpate.benchmarks.jitter.trace.FlightRecording;

/** The main class of an experiment's JVM. Its one argument is the folder of the experiment. */
public final class ExperimentMain {
  private ExperimentMain() {}

  /** Runs the experiment and writes its files; a throwable ends the process with exit code 1. */
  public static void main(String[] arguments) throws Exception {
    ExperimentFolder folder = new ExperimentFolder(Path.of(arguments[0]));
    ExperimentTask task = ExperimentTask.of(ExperimentFolder.read(folder.task()));
    try (ExperimentFrame frame = ExperimentFrame.of(task)) {
      if (task.training()) {
        run(task, frame);
      } else {
        measure(folder, task, frame);
      }
    }
    System.exit(0); // the threads of a window would keep the JVM alive
  }

  private static void measure(ExperimentFolder folder, ExperimentTask task, ExperimentFrame frame)
      throws Exception {
    ExperimentLoop loop;
    try (Recording recording = new Recording()) {
      FlightRecording.enable(recording);
      recording.start();
      ClockPair.emit();
      loop = run(task, frame);
      ClockPair.emit();
      recording.stop();
      recording.dump(folder.recording());
    }
    loop.samples().write(folder.samples());
    Properties outcome = loop.outcome();
    recordCollections(outcome);
    folder.writeOutcome(outcome);
  }

  private static ExperimentLoop run(ExperimentTask task, ExperimentFrame frame)
      throws InterruptedException {
    task.load().start();
    ExperimentLoop loop = new ExperimentLoop(task, frame);
    Thread thread = new Thread(loop, Experiment.THREAD_NAME);
    thread.start();
    thread.join();
    if (loop.failure() != null) {
      throw new IllegalStateException("the loop ended early", loop.failure());
    }
    return loop;
  }

  /** Records the number of collections since the start of this JVM. */
  private static void recordCollections(Properties outcome) {
    long collections = 0;
    for (GarbageCollectorMXBean collector : ManagementFactory.getGarbageCollectorMXBeans()) {
      collections += Math.max(0, collector.getCollectionCount());
    }
    outcome.setProperty("collections", Long.toString(collections));
  }
}
