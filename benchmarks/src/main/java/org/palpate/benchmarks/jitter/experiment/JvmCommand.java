package org.palpate.benchmarks.jitter.experiment;

import java.util.ArrayList;
import java.util.List;
import org.palpate.benchmarks.jitter.trace.ExperimentFolder;

/** The command line of the JVM of a cell. */
public final class JvmCommand {
  /** From this release on a program must be given leave to call native code. */
  private static final int ASKS_FOR_NATIVE_ACCESS = 22;

  private static final int ALLOCATED_MB_A_SECOND = 105;
  private static final int SECONDS_AROUND = 12;

  private final String classPath;

  /**
   * @param classPath where {@link ExperimentMain} and all it needs is found
   */
  JvmCommand(String classPath) {
    this.classPath = classPath;
  }

  /** The run that is measured. */
  List<String> measuring(Experiment cell, ExperimentFolder folder) {
    List<String> command = base(cell, folder);
    command.addAll(cell.jit().flags(folder.archive()));
    return withMain(command, folder);
  }

  /** The run that leaves an archive. */
  List<String> training(Experiment cell, ExperimentFolder folder) {
    List<String> command = base(cell, folder);
    command.addAll(cell.jit().trainingFlags(folder.archive()));
    return withMain(command, folder);
  }

  /** A JVM with the cell's flags that ends at once, to see whether it takes them. */
  List<String> probe(Experiment cell) {
    List<String> command = new ArrayList<>(List.of(cell.jdk().java().toString()));
    command.addAll(flags(cell));
    if (!cell.jit().needsTraining()) {
      command.addAll(cell.jit().flags(null));
    }
    command.add("-version");
    return command;
  }

  /** The flags that make a cell what it is, as a report tells them. */
  public static List<String> flags(Experiment cell) {
    List<String> flags = new ArrayList<>();
    flags.addAll(
        cell.collector()
            .flags(cell.jdk().release())
            .orElseThrow(() -> new IllegalArgumentException("no such collector: " + cell.key())));
    int heapMb = heapMb(cell);
    flags.addAll(List.of("-Xms" + heapMb + "m", "-Xmx" + heapMb + "m", "-XX:+AlwaysPreTouch"));
    return flags;
  }

  /** Epsilon never frees, so its heap must hold all that is allocated. */
  public static int heapMb(Experiment cell) {
    boolean fills =
        cell.collector() == Collector.EPSILON && cell.neighbour() == BackgroundLoad.ALLOCATES;
    int needed = ALLOCATED_MB_A_SECOND * (cell.seconds() + SECONDS_AROUND);
    return fills ? Math.max(cell.heapMb(), needed) : cell.heapMb();
  }

  private List<String> base(Experiment cell, ExperimentFolder folder) {
    List<String> command = new ArrayList<>(List.of(cell.jdk().java().toString()));
    command.addAll(flags(cell));
    command.add("-Xlog:gc*:file=" + folder.collectorLog() + "::filecount=0");
    command.add("-XX:FlightRecorderOptions=maxchunksize=256m");
    if (cell.jdk().release() >= ASKS_FOR_NATIVE_ACCESS) {
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
