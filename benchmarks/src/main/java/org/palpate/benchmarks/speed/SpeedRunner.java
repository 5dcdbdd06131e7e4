package org.palpate.benchmarks.speed;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.openjdk.jmh.infra.BenchmarkParams;
import org.openjdk.jmh.profile.GCProfiler;
import org.openjdk.jmh.results.Result;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.ChainedOptionsBuilder;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;
import org.openjdk.jmh.runner.options.VerboseMode;
import org.palpate.benchmarks.SessionJvm;

/** Runs subjects with JMH, each condition in its own processes, and measures their allocations. */
final class SpeedRunner {
  private static final TimeValue QUICK_ITERATION = TimeValue.milliseconds(250);
  private static final TimeValue ITERATION = TimeValue.milliseconds(300);

  /** Start, setup and end of a process, on two processors of an Intel Xeon. */
  private static final double PROCESS_SECONDS = 1.5;

  /** A heap that the voxels fill; a session's collector would need more room. */
  private static final int LARGE_HEAP_MEGABYTES = 8192;

  private final boolean quick;
  private final String data;
  private final Consumer<String> progress;

  /**
   * Creates a runner.
   *
   * @param quick whether to use one fork and short iterations
   * @param data the folder of scans
   * @param progress receives progress lines
   */
  SpeedRunner(boolean quick, String data, Consumer<String> progress) {
    this.quick = quick;
    this.data = data;
    this.progress = progress;
  }

  private static int forks(boolean quick) {
    return quick ? 1 : 3;
  }

  private static int warmUps(boolean quick) {
    return quick ? 2 : 3;
  }

  private static int measurements(boolean quick) {
    return quick ? 3 : 5;
  }

  private static TimeValue iteration(boolean quick) {
    return quick ? QUICK_ITERATION : ITERATION;
  }

  /** Returns about how long the processes of these subjects take together, s. */
  static double expectedSeconds(List<Subject> subjects, boolean quick) {
    int processes = forks(quick) * subjects.stream().mapToInt(Subject::conditions).sum();
    double iterations = warmUps(quick) + measurements(quick);
    return processes
        * (PROCESS_SECONDS + iterations * iteration(quick).convertTo(TimeUnit.MILLISECONDS) / 1e3);
  }

  /** Runs all subjects. */
  List<SpeedRow> run(List<Subject> subjects) throws IOException {
    int all = subjects.stream().mapToInt(Subject::conditions).sum();
    int done = 0;
    List<SpeedRow> rows = new ArrayList<>();
    for (Subject subject : subjects) {
      progress.accept(
          (done + 1) + "-" + (done + subject.conditions()) + " of " + all + ": " + name(subject));
      rows.addAll(run(subject));
      done += subject.conditions();
    }
    return rows;
  }

  private static String name(Subject subject) {
    StringBuilder text = new StringBuilder(subject.group() + ", " + subject.method());
    subject.params().forEach((key, values) -> text.append(", ").append(String.join("|", values)));
    return text.toString();
  }

  private List<SpeedRow> run(Subject subject) throws IOException {
    ChainedOptionsBuilder options =
        new OptionsBuilder()
            .include(
                "^" + subject.type().getName().replace(".", "\\.") + "\\." + subject.method() + "$")
            .forks(forks(quick))
            .warmupIterations(warmUps(quick))
            .warmupTime(iteration(quick))
            .measurementIterations(measurements(quick))
            .measurementTime(iteration(quick))
            .jvmArgs(jvmArguments(subject).toArray(String[]::new))
            .addProfiler(GCProfiler.class)
            .addProfiler(WorkerTime.class)
            .shouldFailOnError(true)
            .verbosity(VerboseMode.SILENT);
    subject.params().forEach(options::param);
    try {
      List<SpeedRow> rows = new ArrayList<>();
      for (RunResult result : new Runner(options.build()).run()) {
        rows.add(row(subject, result));
      }
      return rows;
    } catch (RunnerException e) {
      throw new IOException("benchmark " + name(subject) + " failed: " + e.getMessage(), e);
    }
  }

  /** Returns the flags of a session, so that frames run as fast as there. */
  private List<String> jvmArguments(Subject subject) {
    List<String> arguments = new ArrayList<>(SessionJvm.flags());
    if (subject.heapMegabytes() >= LARGE_HEAP_MEGABYTES) {
      arguments.add("-XX:-UseZGC");
      arguments.add("-XX:+UseParallelGC");
    }
    arguments.add("-Xmx" + subject.heapMegabytes() + "m");
    arguments.add("-Xbatch"); // so that short warm-ups end with compiled code
    arguments.add("-Dpalpate.data=" + data);
    return arguments;
  }

  private static SpeedRow row(Subject subject, RunResult result) {
    BenchmarkParams params = result.getParams();
    Map<String, String> condition = new LinkedHashMap<>();
    for (String key : subject.params().keySet()) {
      condition.put(key, params.getParam(key));
    }
    boolean onOneThread = !"2".equals(condition.get("threads"));
    return new SpeedRow(
        subject.group(),
        subject.method(),
        condition,
        onOneThread ? "ns/op" : result.getPrimaryResult().getScoreUnit(),
        onOneThread ? workerTimes(result) : wallTimes(result),
        subject.isFrame() ? bytes(result.getSecondaryResults()) : Double.NaN);
  }

  private static List<Double> wallTimes(RunResult result) {
    return result.getBenchmarkResults().stream()
        .flatMap(fork -> fork.getIterationResults().stream())
        .map(iteration -> iteration.getPrimaryResult().getScore())
        .sorted()
        .toList();
  }

  private static List<Double> workerTimes(RunResult result) {
    return result.getBenchmarkResults().stream()
        .flatMap(fork -> fork.getIterationResults().stream())
        .map(iteration -> iteration.getSecondaryResults().get(WorkerTime.LABEL).getScore())
        .sorted()
        .toList();
  }

  @SuppressWarnings("rawtypes") // as JMH declares it
  private static double bytes(Map<String, Result> results) {
    return results.entrySet().stream()
        .filter(entry -> entry.getKey().contains("gc.alloc.rate.norm"))
        .mapToDouble(entry -> entry.getValue().getScore())
        .findFirst()
        .orElse(Double.NaN);
  }
}
