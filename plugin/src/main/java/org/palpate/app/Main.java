package org.palpate.app;

import java.io.PrintStream;
import java.nio.charset.StandardCharsets;

/** Where the JVM starts. */
public final class Main {
  private Main() {}

  /** Runs a command and ends the JVM with its exit code. */
  public static void main(String[] arguments) {
    PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    PrintStream err = new PrintStream(System.err, true, StandardCharsets.UTF_8);
    int exitCode = new PalpateCommandLine(out, err).run(arguments);
    EndOfProcess.commandDone(exitCode);
    System.exit(exitCode);
  }
}
