package org.palpate.io.volume;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;

/** Finds the files of the folder of real scans. */
public final class TestData {
  private TestData() {}

  /** Returns a file of the folder; skips the test, and says so, if the file is absent. */
  public static Path file(String name) {
    Path file = Path.of(System.getProperty("palpate.data", "../shared/data")).resolve(name);
    assumeTrue(Files.exists(file), "skipped: no " + file + " (set -Dpalpate.data)");
    return file;
  }
}
