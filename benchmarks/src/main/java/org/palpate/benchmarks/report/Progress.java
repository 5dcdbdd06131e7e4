package org.palpate.benchmarks.report;

import java.io.PrintWriter;
import java.util.function.Consumer;

/** Prints the progress of a study. */
public final class Progress {
  private Progress() {}

  /** Returns a listener that prints each line at once. */
  public static Consumer<String> to(PrintWriter out) {
    return line -> {
      out.println(line);
      out.flush();
    };
  }
}
