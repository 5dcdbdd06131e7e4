package org.palpate.benchmarks.jitter.trace;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Properties;
import org.palpate.io.file.AtomicFile;

/**
 * The files of one cell.
 *
 * <pre>
 *   cell.properties      what to run, written by the command
 *   samples.bin          a record a frame, see {@link Samples}
 *   recording.jfr        the JVM's own events
 *   gc.log               the collector's log
 *   machine.csv          what the kernel counted, by the command
 *   answers.properties   what the system granted, how the warm-up went; last, so it says "whole"
 * </pre>
 */
public final class ExperimentFolder {
  private final Path folder;

  public ExperimentFolder(Path folder) {
    this.folder = folder;
  }

  public Path path() {
    return folder;
  }

  public Path cell() {
    return folder.resolve("cell.properties");
  }

  public Path samples() {
    return folder.resolve("samples.bin");
  }

  public Path recording() {
    return folder.resolve("recording.jfr");
  }

  public Path collectorLog() {
    return folder.resolve("gc.log");
  }

  public Path machine() {
    return folder.resolve("machine.csv");
  }

  public Path output() {
    return folder.resolve("output.txt");
  }

  public Path archive() {
    return folder.resolve("classes.archive");
  }

  private Path answers() {
    return folder.resolve("answers.properties");
  }

  /** Whether the cell ran to its end. */
  public boolean isWhole() {
    return Files.exists(answers());
  }

  /** Makes the cell one that did not run. */
  public void forget() throws IOException {
    Files.deleteIfExists(answers());
  }

  public void writeOutcome(Properties values) throws IOException {
    write(answers(), values);
  }

  public Properties readOutcome() throws IOException {
    return read(answers());
  }

  public static void write(Path file, Properties values) throws IOException {
    try (AtomicFile written = new AtomicFile(file)) {
      values.store(written.stream(), null);
      written.commit();
    }
  }

  public static Properties read(Path file) throws IOException {
    Properties values = new Properties();
    try (var stream = Files.newInputStream(file)) {
      values.load(stream);
    }
    return values;
  }
}
