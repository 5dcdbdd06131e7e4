package org.palpate.benchmarks.jitter.trace;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Properties;
import org.palpate.io.file.AtomicFile;

/**
 * The files of one experiment.
 *
 * <pre>
 *   cell.properties      the task, written by the command
 *   samples.bin          one record for each frame, see {@link Samples}
 *   recording.jfr        the JVM's own events
 *   gc.log               the collector's log
 *   machine.csv          the kernel's counters, written by the command
 *   answers.properties   the outcome of requests and warm-up; written last, so it marks completion
 * </pre>
 */
public final class ExperimentFolder {
  private final Path folder;

  /** Creates the paths; the folder need not exist. */
  public ExperimentFolder(Path folder) {
    this.folder = folder;
  }

  /** Returns the folder. */
  public Path path() {
    return folder;
  }

  /** Returns the file of the task. */
  public Path task() {
    return folder.resolve("cell.properties");
  }

  /** Returns the file of {@link Samples}. */
  public Path samples() {
    return folder.resolve("samples.bin");
  }

  /** Returns the flight recording. */
  public Path recording() {
    return folder.resolve("recording.jfr");
  }

  /** Returns the collector's log. */
  public Path collectorLog() {
    return folder.resolve("gc.log");
  }

  /** Returns the file of {@link MachineSampler}. */
  public Path machine() {
    return folder.resolve("machine.csv");
  }

  /** Returns the file with the output of the process. */
  public Path output() {
    return folder.resolve("output.txt");
  }

  /** Returns the archive of classes from a training run. */
  public Path archive() {
    return folder.resolve("classes.archive");
  }

  private Path outcome() {
    return folder.resolve("answers.properties");
  }

  /** Whether the experiment ran to its end. */
  public boolean isComplete() {
    return Files.exists(outcome());
  }

  /** Marks the experiment as incomplete. */
  public void invalidate() throws IOException {
    Files.deleteIfExists(outcome());
  }

  /** Writes the outcome and thereby marks the experiment as complete. */
  public void writeOutcome(Properties values) throws IOException {
    write(outcome(), values);
  }

  /** Reads the outcome. */
  public Properties readOutcome() throws IOException {
    return read(outcome());
  }

  /** Writes properties atomically. */
  public static void write(Path file, Properties values) throws IOException {
    try (AtomicFile written = new AtomicFile(file)) {
      values.store(written.stream(), null);
      written.commit();
    }
  }

  /** Reads properties. */
  public static Properties read(Path file) throws IOException {
    Properties values = new Properties();
    try (var stream = Files.newInputStream(file)) {
      values.load(stream);
    }
    return values;
  }
}
