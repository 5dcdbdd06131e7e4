package org.palpate.app.output;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.palpate.io.volume.VolumeFormatException;

class WriteFailuresTest {
  private static final Path A = Path.of("a.csv");
  private static final Path B = Path.of("b.csv");

  private final StringWriter said = new StringWriter();
  private final WriteFailures failures = new WriteFailures(new PrintWriter(said));
  private int writes;

  @Test
  void anOutputThatFailedIsPrintedOnceAndSkippedAndTheOthersGoOn() {
    failures.attempt(A, () -> writes++);
    assertEquals(0, failures.exitCode());
    failures.attempt(A, WriteFailuresTest::fail);
    failures.attempt(A, () -> writes += 100);
    failures.attempt(A, WriteFailuresTest::fail);
    failures.attempt(B, () -> writes++);
    assertEquals(2, writes);
    assertEquals(1, failures.exitCode());
    assertEquals(line("a.csv", "disk full"), said.toString());
  }

  private static void fail() throws IOException {
    throw new IOException("disk full");
  }

  private static String line(String file, String cause) {
    return "palpate: could not be written ("
        + cause
        + "): "
        + file
        + ": check the disk and its permissions"
        + System.lineSeparator();
  }

  @Test
  void aFailureThatSomebodyElseFoundCountsToo() {
    failures.report(B, new IOException("gone"));
    failures.report(B, new IOException("gone again"));
    failures.attempt(B, () -> writes++);
    assertEquals(0, writes);
    assertEquals(1, failures.exitCode());
    assertEquals(line("b.csv", "gone"), said.toString());
  }

  @Test
  void theCauseOfAVolumeThatCannotBeWrittenIsTheSystems() {
    IOException cause = new IOException("disk full");
    failures.attempt(
        A,
        () -> {
          throw new VolumeFormatException("the file cannot be written", A, "choose", cause);
        });
    failures.attempt(
        B,
        () -> {
          throw new VolumeFormatException("too many labels", B, "use fewer");
        });
    assertEquals(
        line("a.csv", "disk full") + line("b.csv", "too many labels: b.csv: use fewer"),
        said.toString());
  }
}
