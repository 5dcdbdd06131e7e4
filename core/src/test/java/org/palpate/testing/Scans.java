package org.palpate.testing;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Assumptions;

/** Finds the real scans, in the folder that {@code -Dpalpate.data=DIR} names. */
public final class Scans {
  private Scans() {}

  /** Returns a file of the folder; skips the test, and says so, if the file is absent. */
  public static Path file(String name) {
    Path file = Path.of(System.getProperty("palpate.data", "../shared/data"), name);
    Assumptions.assumeTrue(
        Files.exists(file), () -> "skipped: there is no " + file + " (-Dpalpate.data=DIR)");
    return file;
  }
}
