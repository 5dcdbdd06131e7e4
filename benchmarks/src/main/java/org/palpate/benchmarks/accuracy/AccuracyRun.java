package org.palpate.benchmarks.accuracy;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.DoubleSummaryStatistics;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.palpate.benchmarks.report.Progress;
import org.palpate.benchmarks.report.StudyTable;

/** Runs the study and writes a table and four plots to a folder. */
public final class AccuracyRun {
  private static final double PLOTTED_DEPTH = 5;
  private static final int PLOTTED_FRAMES = 600;

  /** The edges of a voxel in the plots of thick slices. */
  private static final String THICK = "1:1:3";

  private static final List<String> PLOTTED = List.of("paper sampled:1", "guarded", "smooth");

  private AccuracyRun() {}

  /**
   * Runs the study.
   *
   * @param folder the output folder, created if missing
   * @param quick whether to use one depth, one speed and fewer frames
   * @param out receives the table
   * @param progress receives progress lines
   * @return the mean time of each solver relative to the plain baseline
   */
  public static Map<String, Double> run(
      Path folder, boolean quick, PrintWriter out, PrintWriter progress) throws IOException {
    Files.createDirectories(folder);
    AccuracyStudy study = new AccuracyStudy(quick, Progress.to(progress));
    List<AccuracyRow> rows = study.rows();
    print(rows, out);
    StudyTable.ACCURACY.write(folder, rows, AccuracyRow::cells);
    drawFront(folder.resolve("accuracy-front.png"), rows, AccuracyStudy.CUBES);
    drawFront(folder.resolve("accuracy-front-thick.png"), rows, THICK);
    drawSlide(folder.resolve("accuracy-slide.png"), AccuracyStudy.CUBES);
    drawSlide(folder.resolve("accuracy-slide-thick.png"), THICK);
    return timesOverBaseline(rows);
  }

  private static void drawFront(Path file, List<AccuracyRow> rows, String spacing)
      throws IOException {
    AccuracyPlots.plotFront(
        file,
        "Run time against error of the force, for every shape, depth and speed" + voxels(spacing),
        rows.stream()
            .filter(row -> row.edge() == AccuracyStudy.EDGE && row.spacing().equals(spacing))
            .toList());
  }

  /** Returns the edges of a voxel as the end of a title; nothing if voxels are cubes. */
  private static String voxels(String spacing) {
    return spacing.equals(AccuracyStudy.CUBES) ? "" : ", voxels of " + spacing + " mm";
  }

  private static void print(List<AccuracyRow> rows, PrintWriter out) {
    out.printf(
        Locale.ROOT,
        "%-8s %4s %7s %5s %5s  %-19s %8s %7s %7s %6s %7s %5s %9s%n",
        "shape",
        "edge",
        "spacing",
        "depth",
        "speed",
        "solver",
        "rms deg",
        "worst",
        "h std",
        "lag",
        "change",
        "lost",
        "ns/frame");
    for (AccuracyRow row : rows) {
      Accuracy a = row.accuracy();
      out.printf(
          Locale.ROOT,
          "%-8s %4d %7s %5.1f %5.2f  %-19s %8.2f %7.1f %7.3f %6.3f %7.2f %5d %9.0f%n",
          row.shape(),
          row.edge(),
          row.spacing(),
          row.depth(),
          row.speed(),
          row.solver(),
          a.angleRmsDegrees(),
          a.angleWorstDegrees(),
          a.heightStdMm(),
          a.lag(),
          a.forceChange(),
          a.lostFrames(),
          row.nanosPerFrame());
    }
    out.flush();
  }

  private static void drawSlide(Path file, String spacing) throws IOException {
    AccuracyScene scene = AccuracyStudy.scene("sphere", spacing);
    Map<String, double[]> angles = new LinkedHashMap<>();
    for (ComparedSolver one : ComparedSolver.all(scene)) {
      if (PLOTTED.contains(one.name())) {
        angles.put(one.name(), AccuracyStudy.angles(scene, one, PLOTTED_DEPTH, PLOTTED_FRAMES));
      }
    }
    AccuracyPlots.plotSlide(
        file,
        "A slide over a sphere of bits, 5 mm deep, 0.05 mm per frame" + voxels(spacing),
        angles);
  }

  /**
   * Returns the mean over the slides of each series; the baseline's row is the first of a slide.
   */
  private static Map<String, Double> timesOverBaseline(List<AccuracyRow> rows) {
    Map<String, DoubleSummaryStatistics> times = new LinkedHashMap<>();
    double baseline = 0;
    for (AccuracyRow row : rows) {
      if (row.solver().equals(ComparedSolver.BASELINE)) {
        baseline = row.nanosPerFrame();
      }
      times
          .computeIfAbsent(row.series(), series -> new DoubleSummaryStatistics())
          .accept(row.nanosPerFrame() / baseline);
    }
    Map<String, Double> means = new LinkedHashMap<>();
    times.forEach((series, time) -> means.put(series, time.getAverage()));
    return means;
  }
}
