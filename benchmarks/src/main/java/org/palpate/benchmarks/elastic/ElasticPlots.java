package org.palpate.benchmarks.elastic;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries.XYSeriesRenderStyle;
import org.knowm.xchart.style.markers.SeriesMarkers;
import org.palpate.benchmarks.report.Figures;
import org.palpate.benchmarks.rigid.RigidFigure;

/** Draws the figures of elastic segments as PNG files. */
final class ElasticPlots {
  private static final int WIDTH = 1000;
  private static final int HEIGHT = 640;
  private static final double POISSON = 0.4;
  private static final Pattern UPDATE = Pattern.compile("(residual [-0-9.E]+), ([0-9]+) elements");

  private ElasticPlots() {}

  private static XYChart chart(String title, String xAxis, String yAxis) {
    XYChart chart =
        new XYChartBuilder()
            .width(WIDTH)
            .height(HEIGHT)
            .title(title)
            .xAxisTitle(xAxis)
            .yAxisTitle(yAxis)
            .build();
    Figures.plain(chart);
    return chart;
  }

  /** Plots the time of updates against the number of elements. */
  static void plotUpdates(Path file, List<RigidFigure> figures) throws IOException {
    XYChart chart = chart("Time of an update", "elements", "processor time, p99, ms");
    Map<String, TreeMap<Double, Double>> series = new TreeMap<>();
    for (RigidFigure figure : figures) {
      Matcher matcher = UPDATE.matcher(figure.condition());
      if (figure.name().equals(ElasticTimes.UPDATE_P99) && matcher.matches()) {
        series
            .computeIfAbsent(matcher.group(1), name -> new TreeMap<>())
            .put(Double.valueOf(matcher.group(2)), figure.value());
      }
    }
    series.forEach(
        (name, points) ->
            chart.addSeries(name, List.copyOf(points.keySet()), List.copyOf(points.values())));
    Figures.save(chart, file);
  }

  /** Plots the force at rest against the depth of the hand, beside that of a rigid disc. */
  static void plotDepth(Path file, List<RigidFigure> figures) throws IOException {
    XYChart chart = chart("Force at rest", "depth of the hand, mm", "force, N");
    for (String cells : List.of("cells of 8 mm", "cells of 4 mm")) {
      double[] newton =
          figures.stream()
              .filter(f -> f.condition().equals(cells) && f.name().startsWith(PressStudy.FORCE_AT))
              .mapToDouble(RigidFigure::value)
              .toArray();
      chart.addSeries(cells, PressStudy.DEPTHS, newton);
    }
    double[] disc = Arrays.stream(PressStudy.DEPTHS).map(ElasticPlots::forceOfDisc).toArray();
    chart.addSeries("rigid disc of the contact's radius on a half space", PressStudy.DEPTHS, disc);
    Figures.save(chart, file);
  }

  /** Returns the force of the coupling in series with a rigid disc on a half space, N. */
  private static double forceOfDisc(double depthMm) {
    Softness usual = Softness.USUAL;
    double young = usual.youngPascal() / 1e6;
    double compliance = (1 - POISSON * POISSON) / (2 * usual.radiusMm() * young);
    return depthMm / (1 / usual.newtonPerMm() + compliance);
  }

  /** Plots the force while a hand presses, with the frames before which an update came. */
  static void plotTime(Path file, PressStudy study) throws IOException {
    XYChart chart = chart("Force while pressing at 10 mm/s", "time, ms", "force, N");
    double[] newton = study.forceOverTime().stream().mapToDouble(n -> n).toArray();
    double[] millis = new double[newton.length];
    Arrays.setAll(millis, n -> n);
    chart.addSeries("force", millis, newton).setMarker(SeriesMarkers.NONE);
    double[] at = study.updateFrames().stream().mapToDouble(n -> n).toArray();
    double[] there = study.updateFrames().stream().mapToDouble(n -> newton[n]).toArray();
    chart
        .addSeries("updates", at, there)
        .setXYSeriesRenderStyle(XYSeriesRenderStyle.Scatter)
        .setMarker(SeriesMarkers.CIRCLE);
    chart.getStyler().setMarkerSize(5);
    Figures.save(chart, file);
  }
}
