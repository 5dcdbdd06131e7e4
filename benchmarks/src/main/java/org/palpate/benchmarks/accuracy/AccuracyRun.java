package org.palpate.benchmarks.accuracy;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.file.NumberText;

/** Runs the whole study and leaves a table and two pictures in a folder. */
public final class AccuracyRun {
  private static final double PICTURED_DEPTH = 5;
  private static final int PICTURED_FRAMES = 600;
  private static final List<String> PICTURED = List.of("paper sampled:1", "guarded", "smooth");

  private AccuracyRun() {}

  /**
   * Runs it.
   *
   * @param folder made where it is not there
   * @param quick one depth and one speed, fewer frames
   * @param out gets the table
   * @param progress hears what runs
   * @return the mean time of each solver over that of the plain twin
   */
  public static Map<String, Double> run(
      Path folder, boolean quick, PrintWriter out, PrintWriter progress) throws IOException {
    Files.createDirectories(folder);
    AccuracyStudy study =
        new AccuracyStudy(
            quick,
            line -> {
              progress.println(line);
              progress.flush();
            });
    List<AccuracyRow> rows = study.rows();
    tell(rows, out);
    writeTable(folder.resolve("accuracy.csv"), rows);
    AccuracyPlots.plotFront(folder.resolve("accuracy-front.png"), rows);
    pictureSlide(folder.resolve("accuracy-slide.png"));
    return timesOverTwin(rows);
  }

  private static void tell(List<AccuracyRow> rows, PrintWriter out) {
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

  private static void writeTable(Path file, List<AccuracyRow> rows) throws IOException {
    StringBuilder text =
        new StringBuilder(
            "shape,depth_voxels,speed_voxels,solver,angle_rms_deg,angle_worst_deg,height_mean_mm,"
                + "height_std_mm,lag,force_change,lost_frames,ns_per_frame\n");
    for (AccuracyRow row : rows) {
      appendRow(text, row);
    }
    AtomicFile.write(file, text);
  }

  private static void appendRow(StringBuilder text, AccuracyRow row) {
    Accuracy a = row.accuracy();
    text.append(row.shape()).append(',');
    appendNumbers(text, row.depth(), row.speed());
    text.append(row.solver()).append(',');
    appendNumbers(
        text,
        a.angleRmsDegrees(),
        a.angleWorstDegrees(),
        a.heightMeanMm(),
        a.heightStdMm(),
        a.lag(),
        a.forceChange(),
        a.lostFrames());
    text.append(NumberText.text(row.nanosPerFrame())).append('\n');
  }

  private static void appendNumbers(StringBuilder text, double... values) {
    for (double value : values) {
      text.append(NumberText.text(value)).append(',');
    }
  }

  private static void pictureSlide(Path file) throws IOException {
    AccuracyScene scene = new AccuracyScene("sphere", 192);
    Map<String, double[]> angles = new LinkedHashMap<>();
    for (ComparedSolver one : ComparedSolver.all(scene)) {
      if (PICTURED.contains(one.name())) {
        angles.put(one.name(), AccuracyStudy.angles(scene, one, PICTURED_DEPTH, PICTURED_FRAMES));
      }
    }
    AccuracyPlots.plotSlide(
        file, "A slide over a sphere of bits, pressed 5 voxels, 0.05 voxel a frame", angles);
  }

  private static Map<String, Double> timesOverTwin(List<AccuracyRow> rows) {
    Map<String, Double> sums = new LinkedHashMap<>();
    double twin = 0;
    int slides = 0;
    for (AccuracyRow row : rows) {
      if (row.solver().equals(ComparedSolver.BASELINE)) {
        twin = row.nanosPerFrame();
        slides++;
      }
      sums.merge(row.solver(), row.nanosPerFrame() / twin, Double::sum);
    }
    int count = slides;
    sums.replaceAll((solver, sum) -> sum / count);
    return sums;
  }
}
