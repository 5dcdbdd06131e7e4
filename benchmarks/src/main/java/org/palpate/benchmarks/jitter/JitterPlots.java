package org.palpate.benchmarks.jitter;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.HdrHistogram.Histogram;
import org.HdrHistogram.HistogramIterationValue;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler;
import org.knowm.xchart.style.markers.SeriesMarkers;
import org.palpate.benchmarks.jitter.experiment.Experiment;
import org.palpate.benchmarks.jitter.experiment.ExperimentTable;
import org.palpate.benchmarks.jitter.experiment.ExperimentWords;
import org.palpate.benchmarks.jitter.trace.Cause;
import org.palpate.benchmarks.jitter.trace.Timeline;
import org.palpate.benchmarks.report.Figures;

/** Draws percentile curves of each table and a time line of each experiment with its causes. */
final class JitterPlots {
  private static final int WIDTH = 1100;
  private static final int CURVES_HEIGHT = 620;
  private static final int TIMELINE_HEIGHT = 260;
  private static final double NANOS_PER_MICRO = 1e3;
  private static final double MIN_MICROS = 0.01; // a logarithmic axis has no zero
  private static final int STEPS_PER_HALVING = 5;

  /** The colour of a cause is that of its number here, in every plot. */
  private static final List<Cause.Kind> CAUSES = List.of(Cause.Kind.values());

  private final Path folder;

  JitterPlots(Path folder) {
    this.folder = folder;
  }

  static String curvesName(ExperimentTable table) {
    return "curves-" + table.name() + ".png";
  }

  static String timelineName(Experiment experiment) {
    return "time-" + experiment.key() + ".png";
  }

  /** Writes all pictures of a run. */
  void write(JitterRun run) throws IOException {
    for (ExperimentTable table : run.tables()) {
      List<ExperimentResult> results =
          table.experiments().stream()
              .map(experiment -> run.results().get(experiment.key()))
              .filter(result -> result != null)
              .toList();
      if (!results.isEmpty()) {
        save(curves(table, results), curvesName(table));
      }
    }
    for (ExperimentResult result : run.results().values()) {
      save(timeline(result), timelineName(result.experiment()));
    }
  }

  private void save(XYChart chart, String name) throws IOException {
    Figures.save(chart, folder.resolve(name));
  }

  private static XYChart curves(ExperimentTable table, List<ExperimentResult> results) {
    XYChart chart =
        chart(CURVES_HEIGHT, table.question(), "one frame in this many", "is later than, us");
    Map<String, String> names =
        ExperimentWords.differences(results.stream().map(ExperimentResult::experiment).toList());
    chart.getStyler().setXAxisLogarithmic(true);
    chart.getStyler().setLegendPosition(Styler.LegendPosition.OutsideE);
    for (ExperimentResult result : results) {
      List<Double> oneIn = new ArrayList<>();
      List<Double> micros = new ArrayList<>();
      addCurve(result.delays().corrected(), oneIn, micros);
      XYSeries series = chart.addSeries(names.get(result.experiment().key()), oneIn, micros);
      series.setMarker(SeriesMarkers.NONE);
    }
    return chart;
  }

  private static void addCurve(Histogram histogram, List<Double> oneIn, List<Double> micros) {
    for (HistogramIterationValue value : histogram.percentiles(STEPS_PER_HALVING)) {
      double rest = 1 - value.getPercentileLevelIteratedTo() / 100;
      if (rest > 0) {
        oneIn.add(1 / rest);
        micros.add(Math.max(MIN_MICROS, value.getValueIteratedTo() / NANOS_PER_MICRO));
      }
    }
  }

  private static XYChart timeline(ExperimentResult result) {
    String title = ExperimentWords.all(result.experiment());
    XYChart chart = chart(TIMELINE_HEIGHT, title, "time, s", "force late by, us");
    chart.getStyler().setLegendPosition(Styler.LegendPosition.OutsideE);
    Timeline timeline = result.timeline();
    List<Double> micros =
        timeline.worstMicros().stream().map(value -> Math.max(MIN_MICROS, value)).toList();
    XYSeries worst = chart.addSeries("worst frame of the moment", timeline.seconds(), micros);
    worst.setMarker(SeriesMarkers.NONE).setLineColor(Color.GRAY).setLineWidth(1);
    Map<Cause.Kind, List<Cause>> byKind = new LinkedHashMap<>();
    result
        .causes()
        .forEach(cause -> byKind.computeIfAbsent(cause.kind(), k -> new ArrayList<>()).add(cause));
    byKind.forEach((kind, causes) -> addMarks(chart, kind, causes, result.firstDueNanos()));
    return chart;
  }

  private static void addMarks(
      XYChart chart, Cause.Kind kind, List<Cause> causes, long firstDueNanos) {
    List<Double> seconds = new ArrayList<>();
    List<Double> micros = new ArrayList<>();
    for (Cause cause : causes) {
      seconds.add((cause.dueNanos() - firstDueNanos) / 1e9);
      micros.add(Math.max(MIN_MICROS, cause.responseNanos() / NANOS_PER_MICRO));
    }
    XYSeries series = chart.addSeries(kind.label(), seconds, micros);
    series.setXYSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Scatter);
    series.setMarker(SeriesMarkers.CIRCLE).setMarkerColor(Figures.colour(CAUSES.indexOf(kind)));
  }

  private static XYChart chart(int height, String title, String x, String y) {
    XYChart chart =
        new XYChartBuilder()
            .width(WIDTH)
            .height(height)
            .title(title)
            .xAxisTitle(x)
            .yAxisTitle(y)
            .theme(Styler.ChartTheme.XChart)
            .build();
    Figures.plain(chart);
    chart.getStyler().setYAxisLogarithmic(true);
    chart.getStyler().setMarkerSize(7);
    return chart;
  }
}
