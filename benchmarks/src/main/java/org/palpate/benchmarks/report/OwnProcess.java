package org.palpate.benchmarks.report;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** Runs a class of a study in a process of its own, with the running Java and class path. */
public final class OwnProcess {
  private OwnProcess() {}

  /**
   * Runs the main method of a class, and waits for its end.
   *
   * @param flags of the JVM
   * @return the lines that it printed; its errors go to the error output of this process
   * @throws IOException if the process ends with another exit code than 0
   */
  public static List<String> lines(Class<?> main, List<String> flags, List<String> arguments)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>();
    command.add(ProcessHandle.current().info().command().orElse("java"));
    command.addAll(flags);
    command.addAll(List.of("-cp", System.getProperty("java.class.path"), main.getName()));
    command.addAll(arguments);
    Process process =
        new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start();
    try {
      String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      int exit = process.waitFor();
      if (exit != 0) {
        throw new IOException("the process of " + main.getSimpleName() + " ended with " + exit);
      }
      return text.lines().toList();
    } finally {
      process.destroyForcibly();
    }
  }
}
