package org.palpate.benchmarks.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** Reads the text files in which Linux describes the machine; empty on other systems. */
public final class MachineFiles {
  private MachineFiles() {}

  /** Returns the model name of the processor. */
  public static Optional<String> processor() {
    return field("/proc/cpuinfo", "model name");
  }

  /** Returns the text after the colon in the first line that starts with a name. */
  public static Optional<String> field(String file, String name) {
    return text(file)
        .flatMap(text -> text.lines().filter(line -> line.startsWith(name)).findFirst())
        .map(line -> line.substring(line.indexOf(':') + 1).trim());
  }

  /** Returns the first line of a file. */
  public static Optional<String> line(String file) {
    return text(file).map(text -> text.lines().findFirst().orElse("").trim());
  }

  private static Optional<String> text(String file) {
    try {
      return Optional.of(Files.readString(Path.of(file)));
    } catch (IOException e) {
      return Optional.empty(); // a system without this file
    }
  }
}
