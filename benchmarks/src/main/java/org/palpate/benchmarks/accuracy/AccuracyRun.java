package org.palpate.benchmarks.accuracy;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.palpate.benchmarks.report.Progress;
import org.palpate.benchmarks.report.StudyTable;

/** Runs the study and writes a table and two plots to a folder. */
public final class AccuracyRun {
  private static final double PLOTTED_DEPTH = 5;
  private static final int PLOTTED_FRAMES = 600;
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
    AccuracyPlots.plotFront(folder.resolve("accuracy-front.png"), rows);
    drawSlide(folder.resolve("accuracy-slide.png"));
    return timesOverBaseline(rows);
  }

  private static void print(List<AccuracyRow> rows, PrintWriter out) {
    out.printf(
        Locale.ROOT,
        "%-8s %5s %5s  %-19s %8s %7s %7s %6s %7s %5s %9s%n",
        "shape",
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
          "%-8s %5.1f %5.2f  %-19s %8.2f %7.1f %7.3f %6.3f %7.2f %5d %9.0f%n",
          row.shape(),
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

  private static void drawSlide(Path file) throws IOException {
    AccuracyScene scene = new AccuracyScene("sphere", 192);
    Map<String, double[]> angles = new LinkedHashMap<>();
    for (ComparedSolver one : ComparedSolver.all(scene)) {
      if (PLOTTED.contains(one.name())) {
        angles.put(one.name(), AccuracyStudy.angles(scene, one, PLOTTED_DEPTH, PLOTTED_FRAMES));
      }
    }
    AccuracyPlots.plotSlide(
        file, "A slide over a sphere of bits, 5 voxels deep, 0.05 voxel per frame", angles);
  }

  private static Map<String, Double> timesOverBaseline(List<AccuracyRow> rows) {
    Map<String, Double> sums = new LinkedHashMap<>();
    double baseline = 0;
    int slides = 0;
    for (AccuracyRow row : rows) {
      if (row.solver().equals(ComparedSolver.BASELINE)) {
        baseline = row.nanosPerFrame();
        slides++;
      }
      sums.merge(row.solver(), row.nanosPerFrame() / baseline, Double::sum);
    }
    int count = slides;
    sums.replaceAll((solver, sum) -> sum / count);
    return sums;
  }
}
