package org.palpate.app;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.palpate.app.process.ShutdownHook;
import org.palpate.app.process.StandardOutput;
import org.palpate.display.DisplayLoss;

/** The entry point of the program. */
public final class Main {
  private Main() {}

  /** Runs a command and exits the JVM with its exit code. */
  public static void main(String[] arguments) {
    // Windows are JOGL's; without Java's desktop no command needs a display of AWT.
    System.setProperty("java.awt.headless", "true");
    PrintStream err = new PrintStream(System.err, true, StandardCharsets.UTF_8);
    StandardOutput system = new StandardOutput(new FileOutputStream(FileDescriptor.out), err);
    PrintStream out = new PrintStream(system, true, StandardCharsets.UTF_8);
    ShutdownHook.install();
    int exitCode = system.exitCode(new PalpateCommandLine(out, err).run(arguments));
    ShutdownHook.commandDone(exitCode);
    DisplayLoss.exitIfLost(exitCode);
    System.exit(exitCode);
  }
}
