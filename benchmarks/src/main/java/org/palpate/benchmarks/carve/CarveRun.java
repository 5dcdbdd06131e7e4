package org.palpate.benchmarks.carve;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.palpate.benchmarks.report.MachineSummary;
import org.palpate.benchmarks.report.Progress;
import org.palpate.benchmarks.report.StudyTable;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.benchmarks.rigid.RigidRun;

/** Runs the studies of tools that cut, prints their figures, and writes a table. */
public final class CarveRun {
  private CarveRun() {}

  /**
   * Runs the studies.
   *
   * @param folder the output folder, created if missing
   * @param quick whether to run fewer frames
   * @param seed of scenes and hands
   * @param out receives the figures
   * @param progress receives progress lines
   * @return the number of figures that miss their targets
   */
  public static long run(
      Path folder, boolean quick, long seed, PrintWriter out, PrintWriter progress)
      throws IOException {
    Files.createDirectories(folder);
    out.println(MachineSummary.line(MachineSummary.facts()) + ", seed " + seed);
    Progress.to(progress).accept("times of cutting");
    List<RigidFigure> figures = new ArrayList<>(new CarveTimes(quick ? 3_000 : 30_000).figures());
    RigidRun.print(figures, out);
    Progress.to(progress).accept("surfaces while cutting");
    List<RigidFigure> surfaces = new RemeshTimes(quick ? 3_000 : 30_000).figures();
    RigidRun.print(surfaces, out);
    figures.addAll(surfaces);
    Progress.to(progress).accept("attack on tools that cut");
    List<RigidFigure> attack = new CarveStudy(seed).figures(quick ? 20_000 : 1_000_000);
    RigidRun.print(attack, out);
    figures.addAll(attack);
    StudyTable.CARVE.write(folder, figures, RigidFigure::cells);
    return RigidRun.printMissed(figures, out);
  }
}
