package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.palpate.app.PalpateCommandLine;

/**
 * The result of a command.
 *
 * @param exitCode the exit code of the process
 * @param out the standard output
 * @param err the standard error
 */
record CommandRun(int exitCode, String out, String err) {

  /** Runs a command in this JVM. */
  static CommandRun of(Object... arguments) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ByteArrayOutputStream err = new ByteArrayOutputStream();
    int exitCode =
        new PalpateCommandLine(
                new PrintStream(out, true, StandardCharsets.UTF_8),
                new PrintStream(err, true, StandardCharsets.UTF_8))
            .run(texts(arguments).toArray(String[]::new));
    return new CommandRun(
        exitCode, out.toString(StandardCharsets.UTF_8), err.toString(StandardCharsets.UTF_8));
  }

  /** Returns the command line that runs a command in a JVM of its own. */
  static ProcessBuilder inOwnJvm(Path javaHome, List<String> jvmOptions, Object... arguments) {
    List<String> command = new ArrayList<>();
    command.add(javaHome.resolve("bin").resolve("java").toString());
    command.addAll(jvmOptions);
    command.addAll(List.of("-cp", System.getProperty("java.class.path")));
    command.add("org.palpate.app.Main");
    command.addAll(texts(arguments));
    return new ProcessBuilder(command);
  }

  /** Runs a command in a JVM of its own and waits for it. */
  static CommandRun waitFor(ProcessBuilder builder) throws IOException, InterruptedException {
    Path err = Files.createTempFile("palpate-err", ".txt");
    Process process = builder.redirectError(err.toFile()).start();
    String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    int exitCode = process.waitFor();
    String errors = Files.readString(err);
    Files.delete(err);
    return new CommandRun(exitCode, out, errors);
  }

  private static List<String> texts(Object... arguments) {
    return java.util.Arrays.stream(arguments).map(Object::toString).toList();
  }

  /** Asserts that the command succeeded. */
  CommandRun mustSucceed() {
    assertEquals(0, exitCode, () -> "exit code; standard error was: " + err);
    return this;
  }

  /** Asserts that the command refused its input, and returns the one line that it printed. */
  String mustRefuse() {
    assertEquals(2, exitCode, () -> "exit code; standard error was: " + err);
    assertEquals(1, err.lines().count(), () -> "lines on standard error: " + err);
    String line = err.strip();
    assertTrue(line.matches("palpate: .+: .+: .+"), () -> "not in three parts: " + line);
    assertTrue(!line.contains("Exception"), () -> "names a Java class: " + line);
    return line;
  }
}
