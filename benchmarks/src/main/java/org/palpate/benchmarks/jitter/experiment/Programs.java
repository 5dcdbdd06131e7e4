package org.palpate.benchmarks.jitter.experiment;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;

/** Finds programs of this machine. */
final class Programs {
  private Programs() {}

  /** Whether {@code PATH} contains a program of this name. */
  static boolean has(String name) {
    String path = System.getenv("PATH");
    for (String folder : path == null ? new String[0] : path.split(File.pathSeparator, -1)) {
      if (Files.isExecutable(Path.of(folder, name))) {
        return true;
      }
    }
    return false;
  }
}
