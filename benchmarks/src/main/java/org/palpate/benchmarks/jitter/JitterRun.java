package org.palpate.benchmarks.jitter;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.palpate.benchmarks.jitter.experiment.Experiment;
import org.palpate.benchmarks.jitter.experiment.ExperimentRunner;
import org.palpate.benchmarks.jitter.experiment.ExperimentTable;

/** Runs the experiments of some tables one after the other and collects the results. */
final class JitterRun {
  /** Time of a process besides its measured time: start, warm-up and evaluation, s. */
  static final int OVERHEAD_SECONDS = 4;

  private static final String TIME_IS_UP = "the time is up; run the same command to continue";
  private static final double NANOS_PER_MICRO = 1e3;

  private final List<ExperimentTable> tables;
  private final ExperimentRunner runner;
  private final double budgetSeconds;
  private final long startNanos = System.nanoTime();
  private final PrintWriter out;
  private final Map<String, ExperimentResult> results = new LinkedHashMap<>();
  private final Map<String, String> skipped = new LinkedHashMap<>();

  /**
   * Creates a run.
   *
   * @param budgetSeconds no experiment starts after this time
   */
  JitterRun(
      List<ExperimentTable> tables,
      ExperimentRunner runner,
      double budgetSeconds,
      PrintWriter out) {
    this.tables = tables;
    this.budgetSeconds = budgetSeconds;
    this.runner = runner;
    this.out = out;
  }

  /** Returns the experiments of the tables, each once, in their order. */
  static List<Experiment> experiments(List<ExperimentTable> tables) {
    Map<String, Experiment> byKey = new LinkedHashMap<>();
    tables.forEach(
        table ->
            table
                .experiments()
                .forEach(experiment -> byKey.putIfAbsent(experiment.key(), experiment)));
    return List.copyOf(byKey.values());
  }

  /** Returns the approximate time of these experiments, s. */
  static int secondsFor(List<Experiment> experiments) {
    return experiments.stream()
        .mapToInt(
            experiment -> experiment.seconds() + (experiment.isControl() ? 2 : OVERHEAD_SECONDS))
        .sum();
  }

  /** Runs the incomplete experiments; one that fails is reported and skipped. */
  void run() throws IOException, InterruptedException {
    List<Experiment> experiments = experiments(tables);
    for (int i = 0; i < experiments.size(); i++) {
      Experiment experiment = experiments.get(i);
      String outcome = runOne(experiment);
      String rest = minutes(secondsFor(incomplete(experiments.subList(i + 1, experiments.size()))));
      out.printf(
          Locale.ROOT,
          "[%d/%d] %s  %s  (%s left)%n",
          i + 1,
          experiments.size(),
          experiment.key(),
          outcome,
          rest);
      out.flush();
    }
  }

  private List<Experiment> incomplete(List<Experiment> experiments) throws IOException {
    List<Experiment> rest = new ArrayList<>();
    for (Experiment experiment : experiments) {
      if (!runner.isComplete(experiment)) {
        rest.add(experiment);
      }
    }
    return rest;
  }

  private String runOne(Experiment experiment) throws InterruptedException {
    try {
      Optional<String> why =
          isTimeUp(experiment) ? Optional.of(TIME_IS_UP) : runner.run(experiment);
      if (why.isPresent()) {
        skipped.put(experiment.key(), why.get());
        return "skipped: " + why.get();
      }
      ExperimentResult result = ExperimentResult.of(experiment, runner.folder(experiment));
      results.put(experiment.key(), result);
      return summary(result);
    } catch (IOException e) {
      skipped.put(experiment.key(), e.getMessage());
      return "failed: " + e.getMessage();
    }
  }

  private boolean isTimeUp(Experiment experiment) throws IOException {
    double seconds = (System.nanoTime() - startNanos) / 1e9;
    return seconds > budgetSeconds && !runner.isComplete(experiment);
  }

  private static String summary(ExperimentResult result) {
    var lateness = result.delays().lateness();
    return String.format(
        Locale.ROOT,
        "late p50 %.1f p99 %.1f p99.9 %.1f max %.1f us, worst: %s",
        lateness.getValueAtPercentile(50) / NANOS_PER_MICRO,
        lateness.getValueAtPercentile(99) / NANOS_PER_MICRO,
        lateness.getValueAtPercentile(99.9) / NANOS_PER_MICRO,
        lateness.getMaxValue() / NANOS_PER_MICRO,
        result.causes().get(0).kind().label());
  }

  /** Returns a duration as text, such as {@code 3 min 20 s}. */
  static String minutes(int seconds) {
    return seconds / 60 + " min " + seconds % 60 + " s";
  }

  /** Returns the results by the key of their experiment, in the order of the run. */
  Map<String, ExperimentResult> results() {
    return results;
  }

  /** Returns the reasons why experiments have no result, by key. */
  Map<String, String> skipped() {
    return skipped;
  }

  /** Returns the tables of the run. */
  List<ExperimentTable> tables() {
    return tables;
  }
}
