package org.palpate.app.process;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class ProcessTest {
  private final ByteArrayOutputStream said = new ByteArrayOutputStream();
  private final PrintStream err = new PrintStream(said, true, StandardCharsets.UTF_8);

  /** A stream whose reader goes away, or whose disk is full, after some bytes. */
  private static final class LimitedStream extends OutputStream {
    private final ByteArrayOutputStream taken = new ByteArrayOutputStream();
    private final int most;
    private final String failure;

    LimitedStream(int most, String failure) {
      this.most = most;
      this.failure = failure;
    }

    @Override
    public void write(int b) throws IOException {
      if (taken.size() >= most) {
        throw new IOException(failure);
      }
      taken.write(b);
    }
  }

  @AfterEach
  void restoreTheTerminal() {
    System.clearProperty("palpate.terminal");
  }

  @Test
  void outputPassesThrough() throws IOException {
    LimitedStream system = new LimitedStream(100, "full");
    StandardOutput out = new StandardOutput(system, err);
    out.write('a');
    out.write("bcd".getBytes(StandardCharsets.UTF_8), 1, 2);
    assertArrayEquals("acd".getBytes(StandardCharsets.UTF_8), system.taken.toByteArray());
    assertEquals(0, out.exitCode(0));
    assertEquals(2, out.exitCode(2));
  }

  @Test
  void aFullDiskIsPrintedOnceAndChangesTheExitCode() {
    StandardOutput out = new StandardOutput(new LimitedStream(1, "disk full"), err);
    assertThrows(IOException.class, () -> out.write(new byte[4], 0, 4));
    assertThrows(IOException.class, () -> out.write(1));
    assertEquals(
        "palpate: could not be written (disk full): standard output: check where it goes"
            + System.lineSeparator(),
        said.toString(StandardCharsets.UTF_8));
    assertEquals(1, out.exitCode(0));
    assertEquals(2, out.exitCode(2), "the command's own failure counts more");
  }

  @Test
  void aReaderThatLeavesIsNoFailure() {
    StandardOutput out = new StandardOutput(new LimitedStream(0, "Broken pipe"), err);
    assertThrows(IOException.class, () -> out.write(1));
    assertEquals(0, said.size());
    assertEquals(0, out.exitCode(0));
  }

  @Test
  void aStreamThatGivesNoReasonIsAFailureToo() {
    StandardOutput out = new StandardOutput(new LimitedStream(0, null), err);
    assertThrows(IOException.class, () -> out.write(1));
    assertEquals(1, out.exitCode(0));
  }

  @Test
  void anErrorKeepsLineCodeAndCause() {
    Exception cause = new IllegalStateException("why");
    PalpateException failed = PalpateException.failed("what", "where", "remedy", cause);
    assertEquals("what: where: remedy", failed.getMessage());
    assertEquals(1, failed.exitCode());
    assertSame(cause, failed.getCause());
    PalpateException wrong = PalpateException.wrongUse("what", "where", "remedy", cause);
    assertEquals("what: where: remedy", wrong.getMessage());
    assertEquals(2, wrong.exitCode());
    assertSame(cause, wrong.getCause());
    assertEquals("line", PalpateException.failed("line", cause).getMessage());
    assertEquals(1, PalpateException.failed("line", cause).exitCode());
    assertEquals(2, PalpateException.wrongUse("line", cause).exitCode());
  }

  @Test
  void theLauncherSaysWhetherThereIsATerminal() {
    assertFalse(Terminal.isInteractive());
    System.setProperty("palpate.terminal", "true");
    assertTrue(Terminal.isInteractive());
  }

  @Test
  void aBuildWithoutAJarIsCalledDevelopment() {
    assertEquals("development", VersionProvider.version());
    assertArrayEquals(new String[] {"palpate development"}, new VersionProvider().getVersion());
  }

  @Test
  void shortWorkShowsNoProgress() {
    System.setProperty("palpate.terminal", "true");
    PrintStream before = System.err;
    System.setErr(err);
    try {
      ProgressLine line = new ProgressLine("reading");
      line.slicesRead(1, 100);
      line.slicesRead(100, 100);
    } finally {
      System.setErr(before);
    }
    assertEquals("", said.toString(StandardCharsets.UTF_8));
  }
}
