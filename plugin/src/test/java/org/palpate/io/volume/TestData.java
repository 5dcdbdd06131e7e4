package org.palpate.io.volume;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;

/** The folder of real scans. */
public final class TestData {
  private TestData() {}

  /** A file of it; the test is skipped, and says so, where the folder is absent. */
  public static Path file(String name) {
    Path file = Path.of(System.getProperty("palpate.data", "../shared/data")).resolve(name);
    assumeTrue(Files.exists(file), "skipped: no " + file + " (set -Dpalpate.data)");
    return file;
  }
}
