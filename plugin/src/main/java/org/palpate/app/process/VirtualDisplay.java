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
 * Runs a command on a display of its own if there is none.
 *
 * <p>It starts Xvfb on a free number and runs the command again in a new JVM, because a process
 * cannot change its display after Java has started.
 */
public final class VirtualDisplay {
  /**
   * Name of the class that starts the program; a text, because this package may not use the class.
   */
  static final String MAIN_CLASS = "org.palpate.app.Main";

  private static final String SERVER = "Xvfb";

  /**
   * Runs the command again with a display and returns its exit code.
   *
   * @param arguments the arguments of the program, of which the first is the command
   */
  public int rerun(List<String> arguments) {
    String commandName = arguments.get(0);
    Process server = start(commandName);
    try {
      String number = displayNumber(server);
      List<String> command = javaCommand();
      command.addAll(arguments);
      ProcessBuilder again = new ProcessBuilder(command).inheritIO();
      again.environment().put("DISPLAY", ":" + number);
      return again.start().waitFor();
    } catch (IOException e) {
      throw PalpateException.failed(
          "Xvfb did not start", commandName, "run it yourself and set DISPLAY", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return PalpateException.FAILED;
    } finally {
      server.destroy();
    }
  }

  private static Process start(String commandName) {
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
              "tcp",
              "-noreset") // without it, the server resets when its last client leaves
          .redirectError(ProcessBuilder.Redirect.DISCARD)
          .start();
    } catch (IOException e) {
      throw PalpateException.failed(
          "there is no display, and Xvfb is not installed",
          commandName,
          "install Xvfb with: sudo apt-get install xvfb libgl1 libglx-mesa0 libgl1-mesa-dri",
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
