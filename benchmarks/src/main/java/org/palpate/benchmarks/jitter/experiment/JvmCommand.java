package org.palpate.benchmarks.jitter.experiment;

import java.util.ArrayList;
import java.util.List;
import org.palpate.benchmarks.jitter.trace.ExperimentFolder;

/** Makes the command line of an experiment's JVM. */
public final class JvmCommand {
  /** The first release that warns unless native access is enabled. */
  private static final int NEEDS_NATIVE_ACCESS = 22;

  private static final int ALLOCATED_MB_PER_SECOND = 105;
  private static final int SECONDS_AROUND = 12;

  private final String classPath;

  /**
   * Creates a command.
   *
   * @param classPath the class path of {@link ExperimentMain}
   */
  JvmCommand(String classPath) {
    this.classPath = classPath;
  }

  /** Returns the command of the measured run. */
  List<String> measuring(Experiment experiment, ExperimentFolder folder) {
    List<String> command = base(experiment, folder);
    command.addAll(experiment.jit().flags(folder.archive()));
    return withMain(command, folder);
  }

  /** Returns the command of the run that makes an archive. */
  List<String> training(Experiment experiment, ExperimentFolder folder) {
    List<String> command = base(experiment, folder);
    command.addAll(experiment.jit().trainingFlags(folder.archive()));
    return withMain(command, folder);
  }

  /** Returns the command of a JVM that only checks whether it accepts the flags. */
  List<String> probe(Experiment experiment) {
    List<String> command = new ArrayList<>(List.of(experiment.jdk().java().toString()));
    command.addAll(flags(experiment));
    if (!experiment.jit().needsTraining()) {
      command.addAll(experiment.jit().flags(null));
    }
    command.add("-version");
    return command;
  }

  /** Returns the flags that define the experiment, for reports. */
  public static List<String> flags(Experiment experiment) {
    List<String> flags = new ArrayList<>();
    flags.addAll(
        experiment
            .collector()
            .flags(experiment.jdk().release())
            .orElseThrow(
                () -> new IllegalArgumentException("no such collector: " + experiment.key())));
    int heapMb = heapMb(experiment);
    if (experiment.workload() != Workload.EMPTY) {
      flags.add("-XX:-UsePerfData"); // as the launcher starts a session
    }
    flags.addAll(List.of("-Xms" + heapMb + "m", "-Xmx" + heapMb + "m", "-XX:+AlwaysPreTouch"));
    return flags;
  }

  /** Returns the heap; Epsilon frees nothing, so its heap must hold all allocations. */
  public static int heapMb(Experiment experiment) {
    boolean fills =
        experiment.collector() == Collector.EPSILON
            && experiment.load() == BackgroundLoad.ALLOCATES;
    int needed = ALLOCATED_MB_PER_SECOND * (experiment.seconds() + SECONDS_AROUND);
    return fills ? Math.max(experiment.heapMb(), needed) : experiment.heapMb();
  }

  private List<String> base(Experiment experiment, ExperimentFolder folder) {
    List<String> command = new ArrayList<>(List.of(experiment.jdk().java().toString()));
    command.addAll(flags(experiment));
    command.add("-Xlog:gc*:file=" + folder.collectorLog() + "::filecount=0");
    command.add("-XX:FlightRecorderOptions=maxchunksize=256m");
    if (experiment.jdk().release() >= NEEDS_NATIVE_ACCESS) {
      command.add("--enable-native-access=ALL-UNNAMED");
    }
    return command;
  }

  private List<String> withMain(List<String> command, ExperimentFolder folder) {
    command.addAll(
        List.of("-cp", classPath, ExperimentMain.class.getName(), folder.path().toString()));
    return command;
  }
}
