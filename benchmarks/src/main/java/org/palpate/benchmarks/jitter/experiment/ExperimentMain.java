package org.palpate.benchmarks.jitter.experiment;

import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.Properties;
import jdk.jfr.Recording;
import org.palpate.benchmarks.jitter.trace.ClockPair;
import org.palpate.benchmarks.jitter.trace.ExperimentFolder;
import org.palpate.benchmarks.jitter.trace.FlightRecording;

/** Where the JVM of a cell starts. The one argument is the cell's folder. */
public final class ExperimentMain {
  private static final int TRAINING_FRAMES = 1000;

  private ExperimentMain() {}

  /** Runs the cell and leaves its files; a throwable ends the process with exit code 1. */
  public static void main(String[] arguments) throws Exception {
    ExperimentFolder folder = new ExperimentFolder(Path.of(arguments[0]));
    ExperimentTask task = ExperimentTask.of(ExperimentFolder.read(folder.cell()));
    try (ExperimentFrame frame = ExperimentFrame.of(task)) {
      if (task.training()) {
        run(task, frame, TRAINING_FRAMES);
      } else {
        measure(folder, task, frame);
      }
    }
    System.exit(0); // a window's threads would keep the JVM
  }

  private static void measure(ExperimentFolder folder, ExperimentTask task, ExperimentFrame frame)
      throws Exception {
    ExperimentLoop loop;
    try (Recording recording = new Recording()) {
      FlightRecording.enable(recording);
      recording.start();
      ClockPair.note();
      loop = run(task, frame, task.frames());
      ClockPair.note();
      recording.stop();
      recording.dump(folder.recording());
    }
    loop.samples().write(folder.samples());
    Properties answers = loop.answers();
    recordCollections(answers);
    folder.writeOutcome(answers);
  }

  private static ExperimentLoop run(ExperimentTask task, ExperimentFrame frame, int frames)
      throws Exception {
    task.neighbour().start();
    ExperimentLoop loop = new ExperimentLoop(task.withFrames(frames), frame);
    Thread thread = new Thread(loop, ExperimentLoop.THREAD_NAME);
    thread.start();
    thread.join();
    if (loop.failure() != null) {
      throw new IllegalStateException("the loop ended before its time", loop.failure());
    }
    return loop;
  }

  /** All that the collectors of this JVM did, from its start. */
  private static void recordCollections(Properties answers) {
    long collections = 0;
    for (GarbageCollectorMXBean collector : ManagementFactory.getGarbageCollectorMXBeans()) {
      collections += Math.max(0, collector.getCollectionCount());
    }
    answers.setProperty("collections", Long.toString(collections));
  }
}
