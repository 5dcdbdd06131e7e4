package org.palpate.benchmarks.stability;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.knowm.xchart.CategoryChart;
import org.knowm.xchart.CategoryChartBuilder;
import org.knowm.xchart.CategorySeries;
import org.knowm.xchart.CategorySeries.CategorySeriesRenderStyle;
import org.knowm.xchart.style.Styler.LegendPosition;
import org.knowm.xchart.style.markers.SeriesMarkers;
import org.palpate.benchmarks.report.Figures;
import org.palpate.benchmarks.stability.StabilityStudy.TheoryRow;

/** Draws the results as PNG files. */
final class StabilityPlots {
  private static final int WIDTH = 900;
  private static final int HEIGHT = 600;

  /** Bars end here, because no device renders such a stiffness. */
  private static final double MAX_MARGIN = 20;

  private static final double WANTED_MARGIN = 2;

  private static final double MICROMETRES_PER_MM = 1e3;

  private StabilityPlots() {}

  /** Plots the largest stiffness against the rate for one damping: marks; the theory: lines. */
  static void plotTheory(Path file, List<TheoryRow> rows, double damping) throws IOException {
    List<TheoryRow> drawn =
        rows.stream()
            .filter(row -> row.damping() == damping)
            .filter(row -> row.largest() > 0 && Double.isFinite(row.largest()))
            .toList();
    CategoryChart chart =
        chart("Largest stable stiffness, bare handle on a wall, b = " + damping + " N s/m");
    chart.setXAxisTitle("frames per second");
    chart.setYAxisTitle("N/m");
    chart.getStyler().setYAxisLogarithmic(true).setYAxisDecimalPattern("#,##0");
    chart.getStyler().setOverlapped(true); // marks and lines of a rate coincide
    chart.getStyler().setLegendPosition(LegendPosition.InsideNW);
    double least = drawn.stream().mapToDouble(TheoryRow::largest).min().orElse(1);
    chart.getStyler().setYAxisMin(least / 2); // without bars the axis need not start at 0
    for (int delay = 0; delay <= 2; delay++) {
      addDelay(chart, drawn, delay);
    }
    Figures.save(chart, file);
  }

  private static void addDelay(CategoryChart chart, List<TheoryRow> rows, int delay) {
    List<TheoryRow> own =
        rows.stream().filter(row -> row.sampling().delaySamples() == delay).toList();
    if (own.isEmpty()) {
      return;
    }
    List<String> rates =
        own.stream()
            .map(row -> String.format(Locale.ROOT, "%.0f", row.sampling().rateHz()))
            .toList();
    CategorySeries model =
        chart.addSeries(
            "model, delay " + delay, rates, own.stream().map(TheoryRow::largest).toList());
    model.setChartCategorySeriesRenderStyle(CategorySeriesRenderStyle.Scatter);
    model.setMarkerColor(Figures.colour(delay));
    CategorySeries theory =
        chart.addSeries(
            "theory, delay " + delay, rates, own.stream().map(TheoryRow::passive).toList());
    theory.setChartCategorySeriesRenderStyle(CategorySeriesRenderStyle.Line);
    theory.setMarker(SeriesMarkers.NONE).setLineColor(Figures.colour(delay));
  }

  /** Plots the least margin of each device over the sweep, up to a limit. */
  static void plotMargins(Path file, Map<String, Double> margins) throws IOException {
    CategoryChart chart =
        chart("Least margin of the default stiffness over mass, damping, grip and delay");
    chart.setXAxisTitle("device (model)");
    chart.setYAxisTitle("largest stable / default (cut at " + (int) MAX_MARGIN + ")");
    chart.getStyler().setYAxisMin(0.0);
    chart.getStyler().setOverlapped(true);
    chart.getStyler().setLegendVisible(false);
    List<Double> bars =
        margins.values().stream().map(margin -> Math.min(margin, MAX_MARGIN)).toList();
    List<String> names = List.copyOf(margins.keySet());
    chart.addSeries("margin", names, bars);
    CategorySeries wanted =
        chart.addSeries("wanted", names, Collections.nCopies(names.size(), WANTED_MARGIN));
    wanted.setChartCategorySeriesRenderStyle(CategorySeriesRenderStyle.Line);
    wanted.setMarker(SeriesMarkers.NONE);
    Figures.save(chart, file);
  }

  /** Plots the handle's excursion at rest, at the default stiffness, by shape and solver. */
  static void plotExcursion(Path file, List<MarginRow<Trial>> rows, String device)
      throws IOException {
    CategoryChart chart =
        chart("Excursion of the handle at rest at the default stiffness, " + device);
    chart.setXAxisTitle("shape");
    chart.setYAxisTitle("micrometres");
    chart.getStyler().setLegendPosition(LegendPosition.InsideNW);
    List<String> solvers =
        rows.stream().map(row -> row.trial().solver().name()).distinct().toList();
    for (String solver : solvers) {
      List<MarginRow<Trial>> drawn =
          rows.stream()
              .filter(row -> row.trial().solver().name().equals(solver))
              .filter(row -> row.trial().device().name().equals(device))
              .toList();
      chart.addSeries(
          solver,
          drawn.stream().map(row -> row.trial().shape().name()).toList(),
          drawn.stream().map(row -> MICROMETRES_PER_MM * row.atDefault().excursionMm()).toList());
    }
    Figures.save(chart, file);
  }

  private static CategoryChart chart(String title) {
    CategoryChart chart =
        new CategoryChartBuilder().width(WIDTH).height(HEIGHT).title(title).build();
    Figures.plain(chart);
    chart.getStyler().setLocale(Locale.ROOT);
    return chart;
  }
}
