package org.palpate.benchmarks.accuracy;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries.XYSeriesRenderStyle;
import org.knowm.xchart.style.markers.SeriesMarkers;
import org.palpate.benchmarks.report.Figures;

/** Draws the results as PNG files. */
final class AccuracyPlots {
  private static final int WIDTH = 1000;
  private static final int HEIGHT = 640;

  /** The colour of each solver in every plot, all distinguishable on white. */
  private static final Map<String, Color> COLOURS =
      Map.of(
          ComparedSolver.BASELINE,
          new Color(0x1F4FD8),
          "dot sampled:1",
          new Color(0xF0A000),
          "dot exact",
          new Color(0xA86A00),
          "paper sampled:1",
          new Color(0x7A2FB8),
          "paper sampled:0.25",
          new Color(0xB04FC8),
          "paper gridplanes",
          new Color(0xD070A0),
          "paper exact",
          new Color(0x5A3A80),
          "guarded",
          new Color(0xD02020),
          "smooth",
          new Color(0x101010),
          "smooth grey",
          new Color(0x0A8A8A));

  private AccuracyPlots() {}

  /** Plots time against the angle of the force for every solver on every slide. */
  static void plotFront(Path file, String title, List<AccuracyRow> rows) throws IOException {
    XYChart chart =
        new XYChartBuilder()
            .width(WIDTH)
            .height(HEIGHT)
            .title(title)
            .xAxisTitle("processor time per frame, ns")
            .yAxisTitle("angle of the force to the true normal, degrees rms")
            .build();
    Figures.plain(chart);
    chart.getStyler().setXAxisLogarithmic(true).setYAxisLogarithmic(true);
    chart.getStyler().setDefaultSeriesRenderStyle(XYSeriesRenderStyle.Scatter);
    chart.getStyler().setMarkerSize(7);
    Map<String, List<AccuracyRow>> bySolver = new LinkedHashMap<>();
    for (AccuracyRow row : rows) {
      bySolver.computeIfAbsent(row.solver(), name -> new ArrayList<>()).add(row);
    }
    bySolver.forEach((solver, own) -> addSolver(chart, solver, own));
    Figures.save(chart, file);
  }

  private static void addSolver(XYChart chart, String solver, List<AccuracyRow> rows) {
    double[] nanos = rows.stream().mapToDouble(AccuracyRow::nanosPerFrame).toArray();
    double[] degrees = rows.stream().mapToDouble(row -> row.accuracy().angleRmsDegrees()).toArray();
    chart.addSeries(Figures.words(solver), nanos, degrees).setMarkerColor(COLOURS.get(solver));
  }

  /** Plots the angle of the force for each frame. */
  static void plotSlide(Path file, String title, Map<String, double[]> anglesBySolver)
      throws IOException {
    XYChart chart =
        new XYChartBuilder()
            .width(WIDTH)
            .height(HEIGHT)
            .title(title)
            .xAxisTitle("distance along the surface, mm")
            .yAxisTitle("angle of the force to the true normal, degrees")
            .build();
    Figures.plain(chart);
    anglesBySolver.forEach((solver, angles) -> addSlide(chart, solver, angles));
    Figures.save(chart, file);
  }

  private static void addSlide(XYChart chart, String solver, double[] angles) {
    double[] voxels = new double[angles.length];
    for (int frame = 0; frame < voxels.length; frame++) {
      voxels[frame] = 0.05 * frame;
    }
    chart
        .addSeries(Figures.words(solver), voxels, angles)
        .setMarker(SeriesMarkers.NONE)
        .setLineColor(COLOURS.get(solver));
  }
}
