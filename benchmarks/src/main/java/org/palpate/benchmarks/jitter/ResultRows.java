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

/** A result as fields with names, for tables and for JSON; times in microseconds. */
final class ResultRows {
  private static final double NANOS_A_MICRO = 1e3;
  private static final double BYTES_A_MB = 1e6;
  private static final double[] PERCENTILES = {50, 90, 99, 99.9, 99.99, 99.999};
  private static final String[] NAMES = {"p50", "p90", "p99", "p99_9", "p99_99", "p99_999"};

  private ResultRows() {}

  /** One row of the table of all cells. */
  static Map<String, Object> flat(ExperimentResult result) {
    Experiment cell = result.cell();
    Map<String, Object> row = new LinkedHashMap<>(what(cell));
    DelayHistograms delays = result.delays();
    addFlat(row, "late", delays.lateness());
    addFlat(row, "corrected", delays.corrected());
    addFlat(row, "period", delays.period());
    addFlat(row, "work", delays.work());
    row.putAll(counts(result));
    row.put("worst_cause", result.causes().get(0).kind().label());
    return row;
  }

  private static Map<String, Object> what(Experiment cell) {
    Map<String, Object> row = new LinkedHashMap<>();
    row.put("cell", cell.key());
    row.put("runtime", cell.isControl() ? "c++" : cell.jdk().label());
    row.put("version", cell.isControl() ? "" : cell.jdk().version());
    row.put("collector", cell.isControl() ? "" : cell.collector().label());
    row.put("wait", Experiment.lower(cell.waiting()));
    row.put("scheduling", cell.scheduling().label());
    row.put("workload", cell.workload().label());
    row.put("neighbour", cell.neighbour().label());
    row.put("jit", cell.isControl() ? "" : cell.jit().label());
    row.put("heap_mb", cell.isControl() ? 0 : JvmCommand.heapMb(cell));
    row.put("seconds", cell.seconds());
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
    row.put("longest_pause_us", result.longestPauseNanos() / NANOS_A_MICRO);
    row.put("compilations", result.count(Kind.COMPILATION));
    row.put("deoptimizations", result.count(Kind.DEOPTIMIZATION));
    row.put("frame_allocated_mb", number(result.answer("allocated_bytes")) / BYTES_A_MB);
    row.put("start_to_steady_ms", number(result.answer("start_to_steady_millis")));
    row.put("machine_busy", result.machine().busyShare());
    row.put("machine_stolen", result.machine().stolenShare());
    return row;
  }

  private static double number(String text) {
    return text.isEmpty() ? 0 : Double.parseDouble(text);
  }

  private static void addFlat(Map<String, Object> row, String name, Histogram histogram) {
    percentiles(histogram).forEach((of, value) -> row.put(name + "_" + of + "_us", value));
  }

  /** Percentiles, the maximum last. */
  static Map<String, Object> percentiles(Histogram histogram) {
    Map<String, Object> values = new LinkedHashMap<>();
    for (int i = 0; i < PERCENTILES.length; i++) {
      values.put(NAMES[i], histogram.getValueAtPercentile(PERCENTILES[i]) / NANOS_A_MICRO);
    }
    values.put("max", histogram.getMaxValue() / NANOS_A_MICRO);
    return values;
  }

  /** All that is known of a cell. */
  static Map<String, Object> nested(ExperimentResult result) {
    DelayHistograms delays = result.delays();
    Map<String, Object> row = what(result.cell());
    row.put("late_us", percentiles(delays.lateness()));
    row.put("late_corrected_us", percentiles(delays.corrected()));
    row.put("period_us", percentiles(delays.period()));
    row.put("work_us", percentiles(delays.work()));
    row.putAll(counts(result));
    row.put("answers", answers(result));
    row.put("flags", result.cell().isControl() ? List.of() : JvmCommand.flags(result.cell()));
    List<Object> causes = new ArrayList<>();
    result.causes().forEach(cause -> causes.add(cause(cause, result.firstDueNanos())));
    row.put("worst", causes);
    return row;
  }

  private static Map<String, Object> answers(ExperimentResult result) {
    Map<String, Object> answers = new LinkedHashMap<>();
    result.answers().stringPropertyNames().stream()
        .sorted()
        .forEach(name -> answers.put(name, result.answer(name)));
    return answers;
  }

  private static Map<String, Object> cause(Cause cause, long firstDueNanos) {
    Map<String, Object> row = new LinkedHashMap<>();
    row.put("frame", cause.frame());
    row.put("at_s", (cause.dueNanos() - firstDueNanos) / 1e9);
    row.put("late_us", cause.latenessNanos() / NANOS_A_MICRO);
    row.put("work_us", cause.workNanos() / NANOS_A_MICRO);
    row.put("cause", cause.kind().label());
    row.put("evidence", cause.evidence());
    return row;
  }
}
