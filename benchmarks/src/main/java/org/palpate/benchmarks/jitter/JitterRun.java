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

/** Runs all cells of some tables, tells how far it is, and gathers what they found. */
final class JitterRun {
  /** What a process costs beside its measured time, s: start, warm-up, analysis. */
  static final int OVERHEAD_SECONDS = 4;

  private static final String TIME_IS_UP = "the time is up; the same command again goes on";
  private static final double NANOS_A_MICRO = 1e3;

  private final List<ExperimentTable> tables;
  private final ExperimentRunner runner;
  private final double budgetSeconds;
  private final long beganNanos = System.nanoTime();
  private final PrintWriter out;
  private final Map<String, ExperimentResult> results = new LinkedHashMap<>();
  private final Map<String, String> left = new LinkedHashMap<>();

  /**
   * @param budgetSeconds no cell is begun later than this
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

  /** The cells of the tables, each once, in their order. */
  static List<Experiment> cells(List<ExperimentTable> tables) {
    Map<String, Experiment> byKey = new LinkedHashMap<>();
    tables.forEach(table -> table.cells().forEach(cell -> byKey.putIfAbsent(cell.key(), cell)));
    return List.copyOf(byKey.values());
  }

  /** About how long these cells take, s. */
  static int secondsFor(List<Experiment> cells) {
    return cells.stream()
        .mapToInt(cell -> cell.seconds() + (cell.isControl() ? 2 : OVERHEAD_SECONDS))
        .sum();
  }

  /** Runs what is not whole yet; a cell that fails is told and left out. */
  void run() throws IOException, InterruptedException {
    List<Experiment> cells = cells(tables);
    for (int i = 0; i < cells.size(); i++) {
      Experiment cell = cells.get(i);
      String outcome = runOne(cell);
      String rest = minutes(secondsFor(notWhole(cells.subList(i + 1, cells.size()))));
      out.printf(
          Locale.ROOT,
          "[%d/%d] %s  %s  (%s left)%n",
          i + 1,
          cells.size(),
          cell.key(),
          outcome,
          rest);
      out.flush();
    }
  }

  private List<Experiment> notWhole(List<Experiment> cells) throws IOException {
    List<Experiment> rest = new ArrayList<>();
    for (Experiment cell : cells) {
      if (!runner.isWhole(cell)) {
        rest.add(cell);
      }
    }
    return rest;
  }

  private String runOne(Experiment cell) throws InterruptedException {
    try {
      Optional<String> why = isTimeUp(cell) ? Optional.of(TIME_IS_UP) : runner.run(cell);
      if (why.isPresent()) {
        left.put(cell.key(), why.get());
        return "left out: " + why.get();
      }
      ExperimentResult result = ExperimentResult.of(cell, runner.folder(cell));
      results.put(cell.key(), result);
      return inShort(result);
    } catch (IOException e) {
      left.put(cell.key(), e.getMessage());
      return "failed: " + e.getMessage();
    }
  }

  private boolean isTimeUp(Experiment cell) throws IOException {
    double seconds = (System.nanoTime() - beganNanos) / 1e9;
    return seconds > budgetSeconds && !runner.isWhole(cell);
  }

  private static String inShort(ExperimentResult result) {
    var lateness = result.delays().lateness();
    return String.format(
        Locale.ROOT,
        "late p50 %.1f p99 %.1f p99.9 %.1f max %.1f us, worst: %s",
        lateness.getValueAtPercentile(50) / NANOS_A_MICRO,
        lateness.getValueAtPercentile(99) / NANOS_A_MICRO,
        lateness.getValueAtPercentile(99.9) / NANOS_A_MICRO,
        lateness.getMaxValue() / NANOS_A_MICRO,
        result.causes().get(0).kind().label());
  }

  static String minutes(int seconds) {
    return seconds / 60 + " min " + seconds % 60 + " s";
  }

  /** What the cells found, by their keys, in the order of the run. */
  Map<String, ExperimentResult> results() {
    return results;
  }

  /** Why cells have no result, by their keys. */
  Map<String, String> left() {
    return left;
  }

  List<ExperimentTable> tables() {
    return tables;
  }
}
