package org.palpate.benchmarks.carve;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.palpate.benchmarks.report.MachineSummary;
import org.palpate.benchmarks.report.Progress;
import org.palpate.benchmarks.report.StudyTable;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.benchmarks.rigid.RigidRun;

/** Runs the studies of tools that cut, prints their figures, and writes a table. */
public final class CarveRun {
  /** The frames of a point for each frame of a tool, which takes longer. */
  private static final int POINT_FRAMES_PER_TOOL_FRAME = 100;

  private final List<RigidFigure> figures = new ArrayList<>();
  private final PrintWriter out;
  private final Consumer<String> progress;

  private CarveRun(PrintWriter out, PrintWriter progress) {
    this.out = out;
    this.progress = Progress.to(progress);
  }

  /**
   * Runs the studies.
   *
   * @param folder the output folder, created if missing
   * @param quick whether to time fewer frames
   * @param frames the number of frames in which a point is attacked; each kind of tool is attacked
   *     in a hundredth of them
   * @param seed of scenes and hands
   * @param out receives the figures
   * @param progress receives progress lines
   * @return the number of figures that miss their targets
   */
  public static long run(
      Path folder, boolean quick, long frames, long seed, PrintWriter out, PrintWriter progress)
      throws IOException {
    Files.createDirectories(folder);
    out.println(MachineSummary.line(MachineSummary.facts()) + ", seed " + seed);
    CarveRun run = new CarveRun(out, progress);
    run.measure(quick ? 3_000 : 30_000);
    run.attack(frames, seed);
    StudyTable.CARVE.write(folder, run.figures, RigidFigure::cells);
    return RigidRun.printMissed(run.figures, out);
  }

  private void measure(int frames) {
    progress.accept("times of cutting");
    print(new CarveTimes(frames).figures());
    progress.accept("surfaces while cutting");
    print(RemeshTimes.figures(frames));
  }

  private void attack(long frames, long seed) {
    progress.accept("attack on points that cut");
    print(new PointCarveStudy(seed, progress).figures(frames));
    for (CarveStudy.Tools tools : CarveStudy.Tools.values()) {
      progress.accept("attack on tools that cut");
      print(new CarveStudy(tools, seed, progress).figures(frames / POINT_FRAMES_PER_TOOL_FRAME));
    }
  }

  private void print(List<RigidFigure> measured) {
    RigidRun.print(measured, out);
    figures.addAll(measured);
  }
}
