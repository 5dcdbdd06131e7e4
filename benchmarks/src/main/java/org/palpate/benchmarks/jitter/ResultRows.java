package org.palpate.benchmarks.jitter;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.HdrHistogram.Histogram;
import org.palpate.benchmarks.jitter.experiment.Experiment;
import org.palpate.benchmarks.jitter.experiment.JvmCommand;
import org.palpate.benchmarks.jitter.trace.Cause;
import org.palpate.benchmarks.jitter.trace.DelayHistograms;
import org.palpate.benchmarks.jitter.trace.JvmEvent.Kind;

/** Converts a result to named fields for tables and for JSON; times in microseconds. */
final class ResultRows {
  private static final double NANOS_PER_MICRO = 1e3;
  private static final double BYTES_PER_MB = 1e6;
  private static final double[] PERCENTILES = {50, 90, 99, 99.9, 99.99, 99.999};
  private static final String[] NAMES = {"p50", "p90", "p99", "p99_9", "p99_99", "p99_999"};

  private ResultRows() {}

  /** Returns the row of an experiment in the table of all experiments. */
  static Map<String, Object> flat(ExperimentResult result) {
    Experiment experiment = result.experiment();
    Map<String, Object> row = new LinkedHashMap<>(settings(experiment));
    DelayHistograms delays = result.delays();
    addFlat(row, "late", delays.lateness());
    addFlat(row, "corrected", delays.corrected());
    addFlat(row, "period", delays.period());
    addFlat(row, "work", delays.work());
    row.putAll(counts(result));
    row.put("worst_cause", result.causes().get(0).kind().label());
    return row;
  }

  private static Map<String, Object> settings(Experiment experiment) {
    Map<String, Object> row = new LinkedHashMap<>();
    row.put("cell", experiment.key());
    row.put("runtime", experiment.isControl() ? "c++" : experiment.jdk().label());
    row.put("version", experiment.isControl() ? "" : experiment.jdk().version());
    row.put("collector", experiment.isControl() ? "" : experiment.collector().label());
    row.put("wait", Experiment.lower(experiment.waiting()));
    row.put("scheduling", experiment.scheduling().label());
    row.put("workload", experiment.workload().label());
    row.put("neighbour", experiment.load().label());
    row.put("jit", experiment.isControl() ? "" : experiment.jit().label());
    row.put("heap_mb", experiment.isControl() ? 0 : JvmCommand.heapMb(experiment));
    row.put("seconds", experiment.seconds());
    return row;
  }

  private static Map<String, Object> counts(ExperimentResult result) {
    DelayHistograms delays = result.delays();
    Map<String, Object> row = new LinkedHashMap<>();
    row.put("frames", delays.lateness().getTotalCount());
    row.put("omitted", delays.omitted());
    row.put("over_1_5_ms", delays.overOneAndAHalfMillis());
    row.put("over_10_ms", delays.overTenMillis());
    row.put("pauses", result.count(Kind.GC_PAUSE) + result.count(Kind.SAFEPOINT));
    row.put("longest_pause_us", result.longestPauseNanos() / NANOS_PER_MICRO);
    row.put("compilations", result.count(Kind.COMPILATION));
    row.put("deoptimizations", result.count(Kind.DEOPTIMIZATION));
    row.put("frame_allocated_mb", number(result.outcome("allocated_bytes")) / BYTES_PER_MB);
    row.put("start_to_steady_ms", number(result.outcome("start_to_steady_millis")));
    row.put("machine_busy", result.machine().busyFraction());
    row.put("machine_stolen", result.machine().stolenFraction());
    return row;
  }

  private static double number(String text) {
    return text.isEmpty() ? 0 : Double.parseDouble(text);
  }

  private static void addFlat(Map<String, Object> row, String name, Histogram histogram) {
    percentiles(histogram).forEach((of, value) -> row.put(name + "_" + of + "_us", value));
  }

  /** Returns percentiles by name, then the maximum. */
  static Map<String, Object> percentiles(Histogram histogram) {
    Map<String, Object> values = new LinkedHashMap<>();
    for (int i = 0; i < PERCENTILES.length; i++) {
      values.put(NAMES[i], histogram.getValueAtPercentile(PERCENTILES[i]) / NANOS_PER_MICRO);
    }
    values.put("max", histogram.getMaxValue() / NANOS_PER_MICRO);
    return values;
  }

  /** Returns all that is known of an experiment. */
  static Map<String, Object> nested(ExperimentResult result) {
    DelayHistograms delays = result.delays();
    Map<String, Object> row = settings(result.experiment());
    row.put("late_us", percentiles(delays.lateness()));
    row.put("late_corrected_us", percentiles(delays.corrected()));
    row.put("period_us", percentiles(delays.period()));
    row.put("work_us", percentiles(delays.work()));
    row.putAll(counts(result));
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
