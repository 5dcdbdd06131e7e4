package org.palpate.benchmarks.jitter.experiment;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import org.palpate.benchmarks.jitter.trace.ExperimentFolder;
import org.palpate.realtime.os.OperatingSystem;
import org.palpate.realtime.os.Throttling;

/** The same loop in C++ as a control: compiled from the source in the jar. */
final class ControlProgram {
  private static final String SOURCE = "/org/palpate/realtime/control_loop.cpp";
  private static final int WARM_UP_FRAMES = 1000;
  private static final int COMPILE_SECONDS = 120;

  private final Path program;

  private ControlProgram(Path program) {
    this.program = program;
  }

  /**
   * Compiles the program into the folder unless it is there.
   *
   * @throws IOException if this is not Linux, if there is no C++ compiler, or if it fails
   */
  static ControlProgram in(Path folder) throws IOException {
    Path program = folder.resolve("palpate-control");
    if (!Files.isExecutable(program)) {
      compile(folder, program);
    }
    return new ControlProgram(program);
  }

  private static void compile(Path folder, Path program) throws IOException {
    if (!System.getProperty("os.name").toLowerCase(Locale.ROOT).startsWith("linux")) {
      throw new IOException("the control loop needs Linux");
    }
    Path source = folder.resolve("control_loop.cpp");
    try (InputStream stream = ControlProgram.class.getResourceAsStream(SOURCE)) {
      if (stream == null) {
        throw new IOException("the jar has no " + SOURCE);
      }
      Files.copy(stream, source, StandardCopyOption.REPLACE_EXISTING);
    }
    Process compiler =
        new ProcessBuilder(
                compiler(), "-O2", "-std=c++17", "-o", program.toString(), source.toString())
            .redirectErrorStream(true)
            .redirectOutput(folder.resolve("control_build.txt").toFile())
            .start();
    if (!finishes(compiler) || compiler.exitValue() != 0) {
      throw new IOException("the C++ compiler failed: see " + folder.resolve("control_build.txt"));
    }
  }

  private static boolean finishes(Process compiler) throws IOException {
    try {
      return compiler.waitFor(COMPILE_SECONDS, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted while the control loop was compiled", e);
    }
  }

  private static String compiler() throws IOException {
    for (String name : List.of("c++", "g++", "clang++")) {
      if (Programs.has(name)) {
        return name;
      }
    }
    throw new IOException("no C++ compiler on the path");
  }

  /** Returns the command line of a control experiment. */
  List<String> command(Experiment experiment, ExperimentFolder folder, int frames) {
    boolean fifo = experiment.scheduling().isRealtime();
    OptionalInt cpu = fifo ? OperatingSystem.preferredProcessor() : OptionalInt.empty();
    List<String> command = new ArrayList<>(List.of(program.toString()));
    command.addAll(List.of("--wait", Experiment.lower(experiment.waiting())));
    command.addAll(List.of("--frames", Integer.toString(frames)));
    command.addAll(List.of("--warm-up", Integer.toString(WARM_UP_FRAMES)));
    command.addAll(List.of("--period", Long.toString(experiment.periodNanos())));
    command.addAll(
        List.of("--priority", Integer.toString(fifo ? OperatingSystem.DEFAULT_PRIORITY : 0)));
    command.addAll(List.of("--cpu", Integer.toString(cpu.orElse(-1))));
    command.addAll(List.of("--lock", fifo ? "1" : "0"));
    Throttling throttling = Throttling.read(Path.of("/"));
    command.addAll(List.of("--rest", Long.toString(throttling.restMicros())));
    command.addAll(List.of("--rest-period", Long.toString(throttling.periodMicros())));
    command.addAll(List.of("--out", folder.samples().toString()));
    return command;
  }
}
