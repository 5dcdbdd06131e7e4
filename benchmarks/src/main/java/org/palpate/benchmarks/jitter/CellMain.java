package org.palpate.benchmarks.jitter;

import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.Properties;
import jdk.jfr.Recording;

/** Where the JVM of a cell starts. The one argument is the cell's folder. */
public final class CellMain {
  private static final int TRAINING_FRAMES = 1000;

  private CellMain() {}

  /** Runs the cell and leaves its files; a throwable ends the process with exit code 1. */
  public static void main(String[] arguments) throws Exception {
    CellFolder folder = new CellFolder(Path.of(arguments[0]));
    CellTask task = CellTask.of(CellFolder.read(folder.cell()));
    try (CellFrame frame = CellFrame.of(task)) {
      if (task.training()) {
        run(task, frame, TRAINING_FRAMES);
      } else {
        measure(folder, task, frame);
      }
    }
    System.exit(0); // a window's threads would keep the JVM
  }

  private static void measure(CellFolder folder, CellTask task, CellFrame frame) throws Exception {
    CellLoop loop;
    try (Recording recording = new Recording()) {
      FlightEvents.enable(recording);
      recording.start();
      ClockPair.note();
      loop = run(task, frame, task.frames());
      ClockPair.note();
      recording.stop();
      recording.dump(folder.recording());
    }
    loop.samples().write(folder.samples());
    Properties answers = loop.answers();
    noteCollections(answers);
    folder.writeAnswers(answers);
  }

  private static CellLoop run(CellTask task, CellFrame frame, int frames) throws Exception {
    task.neighbour().start();
    CellLoop loop = new CellLoop(task.withFrames(frames), frame);
    Thread thread = new Thread(loop, CellLoop.THREAD_NAME);
    thread.start();
    thread.join();
    if (loop.failure() != null) {
      throw new IllegalStateException("the loop ended before its time", loop.failure());
    }
    return loop;
  }

  /** All that the collectors of this JVM did, from its start. */
  private static void noteCollections(Properties answers) {
    long collections = 0;
    for (GarbageCollectorMXBean collector : ManagementFactory.getGarbageCollectorMXBeans()) {
      collections += Math.max(0, collector.getCollectionCount());
    }
    answers.setProperty("collections", Long.toString(collections));
  }
}
