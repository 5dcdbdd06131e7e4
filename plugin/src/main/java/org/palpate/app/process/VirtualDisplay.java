package org.palpate.app.process;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * A display of our own where there is none: starts Xvfb on a free number and runs the command again
 * in a new JVM that draws there, because a process cannot change its display once Java has started.
 */
public final class VirtualDisplay {
  /** The class that starts the program; named as text because this package may not use it. */
  static final String MAIN_CLASS = "org.palpate.app.Main";

  private static final String SERVER = "Xvfb";

  /** Runs the same command with a display; its exit code is the answer. */
  public int rerun(List<String> arguments) {
    Process server = start();
    try {
      String number = displayNumber(server);
      List<String> command = javaCommand();
      command.addAll(arguments);
      ProcessBuilder again = new ProcessBuilder(command).inheritIO();
      again.environment().put("DISPLAY", ":" + number);
      return again.start().waitFor();
    } catch (IOException e) {
      throw PalpateException.failed(
          "Xvfb did not start", "render", "run it by hand and set DISPLAY", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return PalpateException.FAILED;
    } finally {
      server.destroy();
    }
  }

  private static Process start() {
    try {
      return new ProcessBuilder(
              SERVER,
              "-displayfd",
              "1",
              "-screen",
              "0",
              "1280x1024x24",
              "+extension",
              "GLX",
              "-nolisten",
              "tcp")
          .redirectError(ProcessBuilder.Redirect.DISCARD)
          .start();
    } catch (IOException e) {
      throw PalpateException.failed(
          "there is no display and no Xvfb",
          "render",
          "install it with: sudo apt-get install xvfb libgl1 libglx-mesa0 libgl1-mesa-dri",
          e);
    }
  }

  private static String displayNumber(Process server) throws IOException {
    BufferedReader reader =
        new BufferedReader(
            new InputStreamReader(server.getInputStream(), StandardCharsets.US_ASCII));
    String number = reader.readLine();
    if (number == null) {
      throw new IOException("Xvfb ended without naming a display");
    }
    return number.trim();
  }

  private static List<String> javaCommand() {
    List<String> command = new ArrayList<>();
    command.add(System.getProperty("java.home") + File.separator + "bin" + File.separator + "java");
    command.addAll(ManagementFactory.getRuntimeMXBean().getInputArguments());
    command.add("-cp");
    command.add(System.getProperty("java.class.path"));
    command.add(MAIN_CLASS);
    return command;
  }
}
