package org.palpate.app.output;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;
import org.palpate.app.process.OutputPaths;
import org.palpate.app.process.PalpateException;
import org.palpate.io.volume.VolumeFormatException;

/**
 * Lets a command continue when one of its outputs fails. Prints one line at the first failure of an
 * output, and skips that output from then on. One thread.
 */
public final class WriteFailures {
  private final PrintWriter err;
  private final Set<Path> failed = new HashSet<>();

  /** A piece of writing. */
  public interface Writing {
    /** Writes. */
    void run() throws IOException;
  }

  /**
   * Creates a list without failures.
   *
   * @param err receives a line for each output that fails
   */
  public WriteFailures(PrintWriter err) {
    this.err = err;
  }

  /** Writes a piece of an output, unless that output failed before. */
  public void attempt(Path target, Writing piece) {
    if (failed.contains(target)) {
      return;
    }
    try {
      piece.run();
    } catch (IOException e) {
      report(target, e);
    }
  }

  /** Prints that an output failed, unless it was printed before. */
  public void report(Path target, IOException cause) {
    if (failed.add(target)) {
      err.println(line(target, cause));
    }
  }

  /** Returns the line about an output that cannot be written. */
  public static String line(Path target, IOException failure) {
    IOException cause =
        failure instanceof VolumeFormatException && failure.getCause() instanceof IOException first
            ? first
            : failure;
    return "palpate: " + OutputPaths.failed(target, cause).getMessage();
  }

  /** Returns 1 if any output failed, otherwise 0. */
  public int exitCode() {
    return failed.isEmpty() ? 0 : PalpateException.FAILED;
  }
}
