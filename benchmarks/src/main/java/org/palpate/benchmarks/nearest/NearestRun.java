package org.palpate.benchmarks.nearest;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.BitmapEncoder.BitmapFormat;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.style.Styler.LegendPosition;
import org.palpate.benchmarks.report.Figures;
import org.palpate.benchmarks.report.Progress;
import org.palpate.benchmarks.report.StudyTable;
import org.palpate.io.file.AtomicFile;

/** Runs the study and writes a table and a plot to a folder. */
public final class NearestRun {
  private static final long SEED = 7;
  private static final int PRESSES = 60;
  private static final int QUICK_PRESSES = 10;
  private static final int WIDTH = 640;
  private static final int HEIGHT = 430;

  private NearestRun() {}

  /**
   * Runs the study.
   *
   * @param folder the output folder, created if missing
   * @param quick whether to use fewer presses
   * @param out receives the table
   * @param progress receives progress lines
   */
  public static void run(Path folder, boolean quick, PrintWriter out, PrintWriter progress)
      throws IOException {
    Files.createDirectories(folder);
    NearestStudy study =
        new NearestStudy(quick ? QUICK_PRESSES : PRESSES, SEED, Progress.to(progress));
    List<NearestRow> rows = study.rows();
    print(rows, out);
    StudyTable.NEAREST.write(folder, rows, NearestRow::cells);
    plot(folder.resolve("nearest.png"), rows);
  }

  private static void print(List<NearestRow> rows, PrintWriter out) {
    out.println("voxels beyond the nearest free point, mean / worst, seed " + SEED);
    for (NearestRow row : rows) {
      out.printf(
          Locale.ROOT,
          "%-12s %5.1f deep  %-18s %6.2f / %5.2f  of %d%n",
          row.shape(),
          row.depth(),
          row.solver(),
          row.meanExcess(),
          row.worstExcess(),
          row.presses());
    }
    out.flush();
  }

  private static void plot(Path file, List<NearestRow> rows) throws IOException {
    double most = rows.stream().mapToDouble(NearestRow::meanExcess).max().orElse(1);
    List<XYChart> charts = new ArrayList<>();
    for (String shape : rows.stream().map(NearestRow::shape).distinct().toList()) {
      charts.add(chart(shape, rows.stream().filter(r -> r.shape().equals(shape)).toList(), most));
    }
    try (AtomicFile out = new AtomicFile(file)) {
      BitmapEncoder.saveBitmap(charts, 2, charts.size() / 2, out.stream(), BitmapFormat.PNG);
      out.commit();
    }
  }

  private static XYChart chart(String shape, List<NearestRow> rows, double most) {
    XYChart chart =
        new XYChartBuilder()
            .width(WIDTH)
            .height(HEIGHT)
            .title(shape + ": distance beyond the nearest free point, mean")
            .xAxisTitle("depth of the device, voxels")
            .yAxisTitle("voxels")
            .build();
    Figures.plain(chart);
    chart.getStyler().setLegendPosition(LegendPosition.InsideNW);
    chart.getStyler().setYAxisMin(Math.min(0, -0.02 * most)).setYAxisMax(1.05 * most);
    for (String solver : rows.stream().map(NearestRow::solver).distinct().toList()) {
      List<NearestRow> own = rows.stream().filter(r -> r.solver().equals(solver)).toList();
      chart.addSeries(
          solver,
          own.stream().map(NearestRow::depth).toList(),
          own.stream().map(NearestRow::meanExcess).toList());
    }
    return chart;
  }
}
