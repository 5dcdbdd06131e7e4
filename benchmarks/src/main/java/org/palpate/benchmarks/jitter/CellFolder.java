package org.palpate.benchmarks.jitter;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Properties;
import org.palpate.io.NewFile;

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
final class CellFolder {
  private final Path folder;

  CellFolder(Path folder) {
    this.folder = folder;
  }

  Path path() {
    return folder;
  }

  Path cell() {
    return folder.resolve("cell.properties");
  }

  Path samples() {
    return folder.resolve("samples.bin");
  }

  Path recording() {
    return folder.resolve("recording.jfr");
  }

  Path collectorLog() {
    return folder.resolve("gc.log");
  }

  Path machine() {
    return folder.resolve("machine.csv");
  }

  Path output() {
    return folder.resolve("output.txt");
  }

  Path archive() {
    return folder.resolve("classes.archive");
  }

  private Path answers() {
    return folder.resolve("answers.properties");
  }

  /** Whether the cell ran to its end. */
  boolean isWhole() {
    return Files.exists(answers());
  }

  /** Makes the cell one that did not run. */
  void forget() throws IOException {
    Files.deleteIfExists(answers());
  }

  void writeAnswers(Properties values) throws IOException {
    write(answers(), values);
  }

  Properties readAnswers() throws IOException {
    return read(answers());
  }

  static void write(Path file, Properties values) throws IOException {
    try (NewFile written = new NewFile(file)) {
      values.store(written.stream(), null);
      written.commit();
    }
  }

  static Properties read(Path file) throws IOException {
    Properties values = new Properties();
    try (var stream = Files.newInputStream(file)) {
      values.load(stream);
    }
    return values;
  }
}
