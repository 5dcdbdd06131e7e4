package org.palpate.benchmarks.jitter;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.HdrHistogram.Histogram;
import org.palpate.benchmarks.jitter.experiment.Experiment;
import org.palpate.benchmarks.jitter.experiment.JvmCommand;
import org.palpate.benchmarks.jitter.trace.Cause;
import org.palpate.benchmarks.jitter.trace.DelayHistograms;
import org.palpate.benchmarks.jitter.trace.JvmEvent.Kind;

/** Converts a result to named fields for tables and for JSON; times in microseconds. */
public final class ResultRows {
  private static final double NANOS_PER_MICRO = 1e3;
  private static final double BYTES_PER_MB = 1e6;
  private static final double[] PERCENTILES = {50, 90, 99, 99.9, 99.99, 99.999};
  private static final List<String> NAMES =
      List.of("p50", "p90", "p99", "p99_9", "p99_99", "p99_999", "max");

  private static final Map<String, Function<Experiment, Object>> SETTINGS = settings();
  private static final Map<String, Function<ExperimentResult, Object>> COUNTS = counts();
  private static final Map<String, Function<ExperimentResult, Object>> COLUMNS = table();

  private ResultRows() {}

  /** Returns the columns of {@code cells.csv}, the table of all experiments, in order. */
  public static List<String> columns() {
    return List.copyOf(COLUMNS.keySet());
  }

  /** Returns the cells of an experiment in these columns. */
  static List<Object> cells(ExperimentResult result) {
    return COLUMNS.values().stream().map(value -> value.apply(result)).toList();
  }

  private static Map<String, Function<ExperimentResult, Object>> table() {
    Map<String, Function<ExperimentResult, Object>> table = new LinkedHashMap<>();
    SETTINGS.forEach((name, value) -> table.put(name, result -> value.apply(result.experiment())));
    addPercentiles(table, "late", DelayHistograms::lateness);
    addPercentiles(table, "corrected", DelayHistograms::corrected);
    addPercentiles(table, "period", DelayHistograms::period);
    addPercentiles(table, "work", DelayHistograms::work);
    table.putAll(COUNTS);
    table.put("worst_cause", result -> result.causes().get(0).kind().label());
    return table;
  }

  private static void addPercentiles(
      Map<String, Function<ExperimentResult, Object>> table,
      String name,
      Function<DelayHistograms, Histogram> histogram) {
    for (String of : NAMES) {
      table.put(
          name + "_" + of + "_us", result -> percentiles(histogram.apply(result.delays())).get(of));
    }
  }

  private static Map<String, Function<Experiment, Object>> settings() {
    Map<String, Function<Experiment, Object>> row = new LinkedHashMap<>();
    row.put("cell", Experiment::key);
    row.put("runtime", experiment -> experiment.isControl() ? "c++" : experiment.jdk().label());
    row.put("version", experiment -> experiment.isControl() ? "" : experiment.jdk().version());
    row.put(
        "collector", experiment -> experiment.isControl() ? "" : experiment.collector().label());
    row.put("wait", experiment -> Experiment.lower(experiment.waiting()));
    row.put("scheduling", experiment -> experiment.scheduling().label());
    row.put("workload", experiment -> experiment.workload().label());
    row.put("neighbour", experiment -> experiment.load().label());
    row.put("jit", experiment -> experiment.isControl() ? "" : experiment.jit().label());
    row.put("heap_mb", experiment -> experiment.isControl() ? 0 : JvmCommand.heapMb(experiment));
    row.put("rate_hz", Experiment::rateHz);
    row.put("seconds", Experiment::seconds);
    return row;
  }

  private static Map<String, Function<ExperimentResult, Object>> counts() {
    Map<String, Function<ExperimentResult, Object>> row = new LinkedHashMap<>();
    row.put("frames", result -> result.delays().lateness().getTotalCount());
    row.put("omitted", result -> result.delays().omitted());
    row.put("over_1_5_ms", result -> result.delays().overOneAndAHalfMillis());
    row.put("over_10_ms", result -> result.delays().overTenMillis());
    row.put("pauses", result -> result.count(Kind.GC_PAUSE) + result.count(Kind.SAFEPOINT));
    row.put("longest_pause_us", result -> result.longestPauseNanos() / NANOS_PER_MICRO);
    row.put("compilations", result -> result.count(Kind.COMPILATION));
    row.put("deoptimizations", result -> result.count(Kind.DEOPTIMIZATION));
    row.put(
        "frame_allocated_mb", result -> number(result.outcome("allocated_bytes")) / BYTES_PER_MB);
    row.put("start_to_steady_ms", result -> number(result.outcome("start_to_steady_millis")));
    row.put("machine_busy", result -> result.machine().busyFraction());
    row.put("machine_stolen", result -> result.machine().stolenFraction());
    return row;
  }

  private static double number(String text) {
    return text.isEmpty() ? 0 : Double.parseDouble(text);
  }

  /** Returns percentiles by name, then the maximum. */
  static Map<String, Object> percentiles(Histogram histogram) {
    Map<String, Object> values = new LinkedHashMap<>();
    for (int i = 0; i < PERCENTILES.length; i++) {
      values.put(NAMES.get(i), histogram.getValueAtPercentile(PERCENTILES[i]) / NANOS_PER_MICRO);
    }
    values.put(NAMES.get(PERCENTILES.length), histogram.getMaxValue() / NANOS_PER_MICRO);
    return values;
  }

  /** Returns all that is known of an experiment. */
  static Map<String, Object> nested(ExperimentResult result) {
    DelayHistograms delays = result.delays();
    Map<String, Object> row = new LinkedHashMap<>();
    SETTINGS.forEach((name, value) -> row.put(name, value.apply(result.experiment())));
    row.put("late_us", percentiles(delays.lateness()));
    row.put("late_corrected_us", percentiles(delays.corrected()));
    row.put("period_us", percentiles(delays.period()));
    row.put("work_us", percentiles(delays.work()));
    COUNTS.forEach((name, value) -> row.put(name, value.apply(result)));
    row.put("answers", outcome(result));
    row.put(
        "flags",
        result.experiment().isControl() ? List.of() : JvmCommand.flags(result.experiment()));
    List<Object> causes = new ArrayList<>();
    result.causes().forEach(cause -> causes.add(cause(cause, result.firstDueNanos())));
    row.put("worst", causes);
    return row;
  }

  private static Map<String, Object> outcome(ExperimentResult result) {
    Map<String, Object> outcome = new LinkedHashMap<>();
    result.outcome().stringPropertyNames().stream()
        .sorted()
        .forEach(name -> outcome.put(name, result.outcome(name)));
    return outcome;
  }

  private static Map<String, Object> cause(Cause cause, long firstDueNanos) {
    Map<String, Object> row = new LinkedHashMap<>();
    row.put("frame", cause.frame());
    row.put("at_s", (cause.dueNanos() - firstDueNanos) / 1e9);
    row.put("late_us", cause.latenessNanos() / NANOS_PER_MICRO);
    row.put("work_us", cause.workNanos() / NANOS_PER_MICRO);
    row.put("cause", cause.kind().label());
    row.put("evidence", cause.evidence());
    return row;
  }
}
