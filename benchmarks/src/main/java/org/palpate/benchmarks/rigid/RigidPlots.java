package org.palpate.benchmarks.rigid;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.knowm.xchart.CategoryChart;
import org.knowm.xchart.CategoryChartBuilder;
import org.knowm.xchart.style.Styler.LegendPosition;
import org.palpate.benchmarks.report.Figures;

/** Draws the figures of each study as bars, with the largest values that meet the targets. */
final class RigidPlots {
  private static final int HEIGHT = 640;
  private static final int LEAST_WIDTH = 640;
  private static final int WIDTH_OF_A_CONDITION = 34;

  private RigidPlots() {}

  /** Writes a plot for each of the main figures. */
  static void write(Path folder, List<RigidFigure> figures) throws IOException {
    plot(folder.resolve("rigid-p50.png"), figures, TimedCondition.STUDY, TimedCondition.P50);
    plot(folder.resolve("rigid-p999.png"), figures, TimedCondition.STUDY, TimedCondition.P999);
    plot(folder.resolve("rigid-angle.png"), figures, "force", "angle of force, rms");
    plot(folder.resolve("rigid-change.png"), figures, "force", "change of force, p99");
    plot(folder.resolve("rigid-peg.png"), figures, "peg", "missing depth, most");
    plot(folder.resolve("rigid-halves.png"), figures, "halves", "residual");
    plot(folder.resolve("rigid-peers.png"), figures, PeerStudy.STUDY, "penetration, most");
  }

  private static void plot(Path file, List<RigidFigure> figures, String study, String name)
      throws IOException {
    List<RigidFigure> own =
        figures.stream().filter(f -> f.study().equals(study) && f.name().equals(name)).toList();
    CategoryChart chart =
        new CategoryChartBuilder()
            .width(Math.max(LEAST_WIDTH, 200 + WIDTH_OF_A_CONDITION * own.size()))
            .height(HEIGHT)
            .title(study + ": " + name)
            .yAxisTitle(own.get(0).unit())
            .build();
    Figures.plain(chart);
    chart.getStyler().setLegendPosition(LegendPosition.InsideNW);
    chart.getStyler().setXAxisLabelRotation(70);
    List<String> conditions = own.stream().map(RigidFigure::condition).toList();
    chart.addSeries("measured", conditions, own.stream().map(RigidFigure::value).toList());
    if (own.stream().anyMatch(RigidFigure::hasTarget)) {
      List<Double> targets =
          own.stream().map(f -> f.hasTarget() ? Double.valueOf(f.target()) : null).toList();
      chart.addSeries("target", conditions, targets);
    }
    Figures.save(chart, file);
  }
}
