package org.palpate.app.process;

import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;

/**
 * The standard output of the process. Prints one line on standard error as soon as a write fails,
 * because a {@link PrintStream} does not report it. A reader that closes its end, as {@code head}
 * does, is no failure.
 */
public final class StandardOutput extends FilterOutputStream {
  private static final String READER_GONE = "Broken pipe";

  private final PrintStream err;
  private volatile boolean failed;

  /** Creates an output over a stream of the system. */
  public StandardOutput(OutputStream system, PrintStream err) {
    super(system);
    this.err = err;
  }

  @Override
  public void write(int b) throws IOException {
    write(new byte[] {(byte) b}, 0, 1);
  }

  @Override
  public void write(byte[] bytes, int from, int count) throws IOException {
    try {
      out.write(bytes, from, count);
    } catch (IOException e) {
      report(e);
      throw e;
    }
  }

  private void report(IOException cause) {
    if (!failed && !String.valueOf(cause.getMessage()).contains(READER_GONE)) {
      failed = true;
      err.println(
          "palpate: could not be written ("
              + cause.getMessage()
              + "): standard output: check where it goes");
    }
  }

  /** Returns the exit code of the process: 1 instead of 0 if a write failed. */
  public int exitCode(int ofCommand) {
    return failed && ofCommand == 0 ? PalpateException.FAILED : ofCommand;
  }
}
