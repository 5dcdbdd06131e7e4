package org.palpate.benchmarks.sync;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.knowm.xchart.CategoryChart;
import org.knowm.xchart.CategoryChartBuilder;
import org.knowm.xchart.CategorySeries.CategorySeriesRenderStyle;
import org.palpate.benchmarks.report.Figures;
import org.palpate.benchmarks.report.Progress;
import org.palpate.benchmarks.report.StudyTable;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.SolverKind;
import org.palpate.io.file.NumberText;
import org.palpate.loop.Median;
import org.palpate.scene.window.GraphicsException;
import org.palpate.volume.phantom.Phantom;

/**
 * Runs the experiment over the head phantom, with all methods in alternation for several rounds,
 * and writes tables and a plot.
 */
public final class SyncRun {
  private static final double WARM_UP_SECONDS = 2;
  private static final double SECONDS = 5;
  private static final double QUICK_SECONDS = 2;
  private static final double[] PERCENTILES = {50, 99, 99.9, 100};

  private SyncRun() {}

  /**
   * Runs the experiment.
   *
   * @param folder the output folder, created if missing
   * @return the median over the rounds of the 99th percentile of a frame's work, microseconds, by
   *     method
   */
  public static Map<String, Double> run(
      Path folder, boolean quick, PrintWriter out, PrintWriter progress)
      throws IOException, GraphicsException, InterruptedException {
    Files.createDirectories(folder);
    List<SyncRow> rows = rows(quick, progress);
    print(rows, out);
    StudyTable.SYNC.write(folder, rows, SyncRow::cells);
    plot(folder.resolve("sync.png"), rows);
    Progress.to(progress).accept("sync: the publication alone");
    List<WriteCost.Row> writes = new WriteCost().measure();
    printWrites(writes, out);
    StudyTable.SYNC_WRITES.write(folder, writes, WriteCost.Row::cells);
    Map<String, Double> p99 = new LinkedHashMap<>();
    for (SyncMethod method : SyncMethod.values()) {
      p99.put(method.title(), median(rows, method, 99));
    }
    return p99;
  }

  private static List<SyncRow> rows(boolean quick, PrintWriter progress)
      throws GraphicsException, InterruptedException {
    ContactSettings settings = ContactSettings.standard(SolverKind.GUARDED);
    ContactScene scene =
        new ContactScene(Phantom.parse(quick ? "head:96" : "head:256").segments(), settings);
    List<SyncRow> rows = new ArrayList<>();
    try (SyncTrial trial = new SyncTrial(scene)) {
      trial.run(SyncMethod.WAIT_FREE, 0, WARM_UP_SECONDS);
      for (int round = 1; round <= (quick ? 1 : 3); round++) {
        for (SyncMethod method : SyncMethod.values()) {
          Progress.to(progress).accept("sync: round " + round + ", " + method.title());
          rows.add(trial.run(method, round, quick ? QUICK_SECONDS : SECONDS));
        }
      }
    }
    return rows;
  }

  private static void print(List<SyncRow> rows, PrintWriter out) {
    out.printf(
        "%-20s %5s %9s %10s %10s %10s %10s %11s %8s%n",
        "method",
        "round",
        "rate Hz",
        "work p50",
        "p99",
        "p99.9",
        "max us",
        "period p99",
        "redraws");
    for (SyncRow row : rows) {
      out.printf(
          Locale.ROOT,
          "%-20s %5d %9.1f %10.1f %10.1f %10.1f %10.1f %11.1f %8d%n",
          row.method().title(),
          row.round(),
          row.rateHz(),
          row.workMicros(50),
          row.workMicros(99),
          row.workMicros(99.9),
          row.workMicros(100),
          row.periodMicros(99),
          row.redraws());
    }
    out.flush();
  }

  private static void printWrites(List<WriteCost.Row> rows, PrintWriter out) {
    out.printf("%n%-20s %12s %12s %12s %12s%n", "a write", "changed ns", "same ns", "p99.9", "max");
    for (WriteCost.Row row : rows) {
      out.printf(
          Locale.ROOT,
          "%-20s %12.1f %12.1f %12d %12d%n",
          row.candidate(),
          row.nanos(),
          row.unchangedNanos(),
          row.p999Nanos(),
          row.maxNanos());
    }
    out.flush();
  }

  private static double median(List<SyncRow> rows, SyncMethod method, double percentile) {
    return Median.of(
        rows.stream()
            .filter(row -> row.method() == method)
            .mapToDouble(row -> row.workMicros(percentile))
            .toArray());
  }

  private static void plot(Path file, List<SyncRow> rows) throws IOException {
    CategoryChart chart =
        new CategoryChartBuilder()
            .width(900)
            .height(560)
            .title("A haptic frame that changes the scene (median of the rounds)")
            .xAxisTitle("frames")
            .yAxisTitle("work up to, microseconds")
            .build();
    chart.getStyler().setYAxisLogarithmic(true);
    // Bars start at zero, which has no logarithm; lines do not.
    chart.getStyler().setDefaultSeriesRenderStyle(CategorySeriesRenderStyle.Line);
    chart.getStyler().setOverlapped(true);
    List<String> labels = new ArrayList<>();
    for (double percentile : PERCENTILES) {
      labels.add(percentile == 100 ? "all" : NumberText.display(percentile) + " %");
    }
    for (SyncMethod method : SyncMethod.values()) {
      List<Double> values = new ArrayList<>();
      for (double percentile : PERCENTILES) {
        values.add(median(rows, method, percentile));
      }
      chart.addSeries(method.title(), labels, values);
    }
    Figures.save(chart, file);
  }
}
