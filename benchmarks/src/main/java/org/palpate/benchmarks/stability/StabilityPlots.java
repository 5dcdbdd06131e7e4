package org.palpate.benchmarks.stability;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.BitmapEncoder.BitmapFormat;
import org.knowm.xchart.CategoryChart;
import org.knowm.xchart.CategoryChartBuilder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.internal.chartpart.Chart;
import org.knowm.xchart.style.Styler.LegendPosition;
import org.knowm.xchart.style.lines.SeriesLines;
import org.knowm.xchart.style.markers.SeriesMarkers;
import org.palpate.benchmarks.stability.StabilityStudy.DeviceRow;
import org.palpate.benchmarks.stability.StabilityStudy.TheoryRow;
import org.palpate.io.NewFile;

/** Draws the study's rows as PNG files. */
final class StabilityPlots {
  private static final int WIDTH = 900;
  private static final int HEIGHT = 600;

  /** Bars above this say no more: the stiffness is beyond what any device renders. */
  private static final double MOST_MARGIN = 20;

  private StabilityPlots() {}

  /** The largest stiffness against the rate for one physical damping: marks; the theory: lines. */
  static void plotTheory(Path file, List<TheoryRow> rows, double damping) throws IOException {
    XYChart chart =
        new XYChartBuilder()
            .width(WIDTH)
            .height(HEIGHT)
            .title("Largest stable stiffness, bare handle on a wall, b = " + damping + " N s/m")
            .xAxisTitle("frames a second")
            .yAxisTitle("N/m")
            .build();
    chart.getStyler().setXAxisLogarithmic(true).setYAxisLogarithmic(true);
    chart.getStyler().setLegendPosition(LegendPosition.InsideNW);
    for (int delay = 0; delay <= 2; delay++) {
      addDelay(chart, rows, damping, delay);
    }
    save(chart, file);
  }

  private static void addDelay(XYChart chart, List<TheoryRow> rows, double damping, int delay) {
    List<Double> rates = new ArrayList<>();
    List<Double> largest = new ArrayList<>();
    List<Double> passive = new ArrayList<>();
    for (TheoryRow row : rows) {
      boolean drawn =
          row.damping() == damping
              && row.sampling().delaySamples() == delay
              && row.largest() > 0
              && Double.isFinite(row.largest());
      if (drawn) {
        rates.add(row.sampling().rateHz());
        largest.add(row.largest());
        passive.add(row.passive());
      }
    }
    if (rates.isEmpty()) {
      return;
    }
    XYSeries model = chart.addSeries("model, delay " + delay, rates, largest);
    model.setLineStyle(SeriesLines.NONE);
    XYSeries theory = chart.addSeries("theory, delay " + delay, rates, passive);
    theory.setMarker(SeriesMarkers.NONE);
  }

  /** The least margin of each device over the sweep, up to a most. */
  static void plotMargins(Path file, Map<String, Double> margins) throws IOException {
    CategoryChart chart =
        new CategoryChartBuilder()
            .width(WIDTH)
            .height(HEIGHT)
            .title("Least margin of the default stiffness over mass, damping, grip and delay")
            .xAxisTitle("device (model)")
            .yAxisTitle("largest stable / default (cut at " + (int) MOST_MARGIN + ")")
            .build();
    chart.getStyler().setLegendVisible(false);
    List<Double> bars =
        margins.values().stream().map(margin -> Math.min(margin, MOST_MARGIN)).toList();
    chart.addSeries("margin", new ArrayList<>(margins.keySet()), bars);
    save(chart, file);
  }

  /** The play of the handle at rest, at the default stiffness, by shape and solver. */
  static void plotPlay(Path file, List<DeviceRow> rows, String device) throws IOException {
    CategoryChart chart =
        new CategoryChartBuilder()
            .width(WIDTH)
            .height(HEIGHT)
            .title("Play of the handle at rest at the default stiffness, " + device)
            .xAxisTitle("shape")
            .yAxisTitle("mm")
            .build();
    chart.getStyler().setLegendPosition(LegendPosition.InsideNW);
    List<String> solvers =
        rows.stream().map(row -> row.trial().solver().name()).distinct().toList();
    for (String solver : solvers) {
      List<DeviceRow> drawn =
          rows.stream()
              .filter(row -> row.trial().solver().name().equals(solver))
              .filter(row -> row.trial().device().name().equals(device))
              .toList();
      chart.addSeries(
          solver,
          drawn.stream().map(row -> row.trial().shape().name()).toList(),
          drawn.stream().map(row -> row.atDefault().playMm()).toList());
    }
    save(chart, file);
  }

  private static void save(Chart<?, ?> chart, Path file) throws IOException {
    try (NewFile out = new NewFile(file)) {
      BitmapEncoder.saveBitmap(chart, out.stream(), BitmapFormat.PNG);
      out.commit();
    }
  }
}
