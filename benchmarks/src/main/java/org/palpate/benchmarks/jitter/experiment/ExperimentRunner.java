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

/** Runs experiments one after the other, each in a fresh process. Belongs to one thread. */
public final class ExperimentRunner {

  private static final int SECONDS_TO_SPARE = 60;
  private static final int PROBE_SECONDS = 30;
  private static final int TRAINING_FRAMES = 1000;

  private final Path root;
  private final String scene;
  private final JvmCommand jvm = new JvmCommand(System.getProperty("java.class.path"));
  private final Map<List<String>, Boolean> probed = new HashMap<>();

  /**
   * Creates a runner.
   *
   * @param root the folder that contains the folders of all experiments
   * @param scene the touched scene; see {@link ExperimentScene}
   */
  public ExperimentRunner(Path root, String scene) {
    this.root = root;
    this.scene = scene;
  }

  /** Returns the folder of an experiment. */
  public ExperimentFolder folder(Experiment experiment) {
    return new ExperimentFolder(root.resolve("cells").resolve(experiment.key()));
  }

  /** Whether the experiment ran to its end with the same task. */
  public boolean isComplete(Experiment experiment) throws IOException {
    ExperimentFolder folder = folder(experiment);
    return folder.isComplete()
        && (experiment.isControl()
            || ExperimentFolder.read(folder.task())
                .equals(task(experiment, frames(experiment), false).toProperties()));
  }

  /**
   * Runs the experiment unless it is complete.
   *
   * @return empty if it is complete now, otherwise the reason why it cannot run here
   * @throws IOException if it ran and failed
   */
  public Optional<String> run(Experiment experiment) throws IOException, InterruptedException {
    if (isComplete(experiment)) {
      return Optional.empty();
    }
    ExperimentFolder folder = folder(experiment);
    folder.invalidate();
    Files.createDirectories(folder.path());
    return experiment.isControl() ? runControl(experiment, folder) : runJvm(experiment, folder);
  }

  private Optional<String> runControl(Experiment experiment, ExperimentFolder folder)
      throws IOException, InterruptedException {
    ControlProgram control;
    try {
      control = ControlProgram.in(root);
    } catch (IOException e) {
      return Optional.of(e.getMessage());
    }
    int frames = frames(experiment);
    watched(control.command(experiment, folder, frames), experiment, folder);
    folder.writeOutcome(outcomeOf(Files.readAllLines(folder.output())));
    return Optional.empty();
  }

  /** Parses lines such as {@code class granted fifo 40} and {@code spin_window_nanos 20000}. */
  static Properties outcomeOf(List<String> lines) {
    Properties outcome = new Properties();
    for (String line : lines) {
      String[] words = line.split(" ", 2);
      boolean isRequest = words.length == 2 && words[1].matches("(granted|refused).*");
      if (words.length == 2) {
        outcome.setProperty(isRequest ? "grant." + words[0] : words[0], words[1]);
      }
    }
    return outcome;
  }

  private Optional<String> runJvm(Experiment experiment, ExperimentFolder folder)
      throws IOException, InterruptedException {
    if (!takesFlags(experiment)) {
      return Optional.of(experiment.jdk().label() + " does not take this experiment's flags");
    }
    if (experiment.jit().needsTraining()) {
      ExperimentFolder.write(folder.task(), task(experiment, TRAINING_FRAMES, true).toProperties());
      finish(jvm.training(experiment, folder), folder, experiment.seconds() + SECONDS_TO_SPARE);
    }
    ExperimentFolder.write(
        folder.task(), task(experiment, frames(experiment), false).toProperties());
    List<String> command = new ArrayList<>();
    if (experiment.workload() == Workload.FRAME_AND_VIEW && !GraphicsDriver.hasDisplay()) {
      if (!Programs.has("xvfb-run")) {
        return Optional.of("no display and no xvfb-run");
      }
      command.addAll(List.of("xvfb-run", "-a"));
    }
    command.addAll(jvm.measuring(experiment, folder));
    watched(command, experiment, folder);
    return Optional.empty();
  }

  private ExperimentTask task(Experiment experiment, int frames, boolean training) {
    return new ExperimentTask(
        experiment.waiting(),
        experiment.scheduling(),
        experiment.workload(),
        experiment.load(),
        frames,
        experiment.periodNanos(),
        scene,
        training);
  }

  private static int frames(Experiment experiment) {
    return Math.multiplyExact(experiment.seconds(), experiment.rateHz());
  }

  private boolean takesFlags(Experiment experiment) throws IOException, InterruptedException {
    List<String> probe = jvm.probe(experiment);
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

  private void watched(List<String> command, Experiment experiment, ExperimentFolder folder)
      throws IOException, InterruptedException {
    try (MachineSampler watch = new MachineSampler()) {
      finish(command, folder, experiment.seconds() + SECONDS_TO_SPARE);
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
