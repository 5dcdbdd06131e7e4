package org.palpate.app;

import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.palpate.app.process.ShutdownHook;
import org.palpate.display.DisplayLoss;

/** Where the JVM starts. */
public final class Main {
  private Main() {}

  /** Runs a command and ends the JVM with its exit code. */
  public static void main(String[] arguments) {
    // No command needs the desktop of Java; windows are JOGL's. Nor is it asked for a display then.
    System.setProperty("java.awt.headless", "true");
    PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    PrintStream err = new PrintStream(System.err, true, StandardCharsets.UTF_8);
    int exitCode = new PalpateCommandLine(out, err).run(arguments);
    ShutdownHook.commandDone(exitCode);
    DisplayLoss.exitIfLost(exitCode);
    System.exit(exitCode);
  }
}
