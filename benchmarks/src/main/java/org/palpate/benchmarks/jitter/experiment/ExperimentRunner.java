package org.palpate.benchmarks.jitter.experiment;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.concurrent.TimeUnit;
import org.palpate.benchmarks.jitter.trace.ExperimentFolder;
import org.palpate.benchmarks.jitter.trace.MachineSampler;
import org.palpate.scene.window.GraphicsDriver;

/** Runs cells, each in a fresh process, one after the other. Belongs to one thread. */
public final class ExperimentRunner {
  public static final long PERIOD_NANOS = 1_000_000;

  private static final long NANOS_A_SECOND = 1_000_000_000L;
  private static final int SECONDS_TO_SPARE = 60;
  private static final int PROBE_SECONDS = 30;
  private static final int TRAINING_FRAMES = 1000;

  private final Path root;
  private final String scene;
  private final JvmCommand jvm = new JvmCommand(System.getProperty("java.class.path"));
  private final Map<List<String>, Boolean> probed = new HashMap<>();

  /**
   * @param root where every cell has its folder
   * @param scene what is touched; see {@link ExperimentScene}
   */
  public ExperimentRunner(Path root, String scene) {
    this.root = root;
    this.scene = scene;
  }

  public ExperimentFolder folder(Experiment cell) {
    return new ExperimentFolder(root.resolve("cells").resolve(cell.key()));
  }

  /** Whether the cell ran to its end, with the same task. */
  public boolean isWhole(Experiment cell) throws IOException {
    ExperimentFolder folder = folder(cell);
    return folder.isWhole()
        && (cell.isControl()
            || ExperimentFolder.read(folder.cell())
                .equals(task(cell, frames(cell), false).toProperties()));
  }

  /**
   * Runs the cell, unless it is whole already.
   *
   * @return empty where it is whole now, else why it cannot be run here
   * @throws IOException where it was run and failed
   */
  public Optional<String> run(Experiment cell) throws IOException, InterruptedException {
    if (isWhole(cell)) {
      return Optional.empty();
    }
    ExperimentFolder folder = folder(cell);
    folder.forget();
    Files.createDirectories(folder.path());
    return cell.isControl() ? runControl(cell, folder) : runJvm(cell, folder);
  }

  private Optional<String> runControl(Experiment cell, ExperimentFolder folder)
      throws IOException, InterruptedException {
    ControlProgram control;
    try {
      control = ControlProgram.in(root);
    } catch (IOException e) {
      return Optional.of(e.getMessage());
    }
    int frames = frames(cell);
    watched(control.command(cell, folder, frames, PERIOD_NANOS), cell, folder);
    folder.writeOutcome(answersOf(Files.readAllLines(folder.output())));
    return Optional.empty();
  }

  /** Lines as {@code class granted fifo 40} and {@code spin_window_nanos 20000}. */
  static Properties answersOf(List<String> lines) {
    Properties answers = new Properties();
    for (String line : lines) {
      String[] words = line.split(" ", 2);
      boolean isGrant = words.length == 2 && words[1].matches("(granted|refused).*");
      if (words.length == 2) {
        answers.setProperty(isGrant ? "grant." + words[0] : words[0], words[1]);
      }
    }
    return answers;
  }

  private Optional<String> runJvm(Experiment cell, ExperimentFolder folder)
      throws IOException, InterruptedException {
    if (!takesFlags(cell)) {
      return Optional.of(cell.jdk().label() + " does not take the flags of this cell");
    }
    if (cell.jit().needsTraining()) {
      ExperimentFolder.write(folder.cell(), task(cell, TRAINING_FRAMES, true).toProperties());
      finish(jvm.training(cell, folder), folder, cell.seconds() + SECONDS_TO_SPARE);
    }
    ExperimentFolder.write(folder.cell(), task(cell, frames(cell), false).toProperties());
    List<String> command = new ArrayList<>();
    if (cell.workload() == Workload.FRAME_AND_VIEW && !GraphicsDriver.hasDisplay()) {
      if (!Programs.has("xvfb-run")) {
        return Optional.of("no display, and no xvfb-run to make one");
      }
      command.addAll(List.of("xvfb-run", "-a"));
    }
    command.addAll(jvm.measuring(cell, folder));
    watched(command, cell, folder);
    return Optional.empty();
  }

  private ExperimentTask task(Experiment cell, int frames, boolean training) {
    return new ExperimentTask(
        cell.waiting(),
        cell.scheduling(),
        cell.workload(),
        cell.neighbour(),
        frames,
        PERIOD_NANOS,
        scene,
        training);
  }

  private static int frames(Experiment cell) {
    return Math.toIntExact(cell.seconds() * NANOS_A_SECOND / PERIOD_NANOS);
  }

  private boolean takesFlags(Experiment cell) throws IOException, InterruptedException {
    List<String> probe = jvm.probe(cell);
    Boolean known = probed.get(probe);
    if (known == null) {
      Process process =
          new ProcessBuilder(probe)
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .start();
      known = process.waitFor(PROBE_SECONDS, TimeUnit.SECONDS) && process.exitValue() == 0;
      process.destroyForcibly();
      probed.put(probe, known);
    }
    return known;
  }

  private void watched(List<String> command, Experiment cell, ExperimentFolder folder)
      throws IOException, InterruptedException {
    try (MachineSampler watch = new MachineSampler()) {
      finish(command, folder, cell.seconds() + SECONDS_TO_SPARE);
      watch.write(folder.machine());
    }
  }

  private static void finish(List<String> command, ExperimentFolder folder, int seconds)
      throws IOException, InterruptedException {
    Process process =
        new ProcessBuilder(command)
            .redirectErrorStream(true)
            .redirectOutput(folder.output().toFile())
            .start();
    try {
      if (!process.waitFor(seconds, TimeUnit.SECONDS)) {
        throw new IOException("did not end in " + seconds + " s: see " + folder.output());
      }
    } finally {
      process.descendants().forEach(ProcessHandle::destroyForcibly);
      process.destroyForcibly();
    }
    if (process.exitValue() != 0) {
      throw new IOException("ended with " + process.exitValue() + ": see " + folder.output());
    }
  }
}
