package org.palpate.benchmarks.elastic;

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

/** Runs the studies of elastic segments, prints their figures, and writes a table and plots. */
public final class ElasticRun {
  private final PrintWriter out;
  private final Consumer<String> progress;
  private final List<RigidFigure> figures = new ArrayList<>();

  private ElasticRun(PrintWriter out, PrintWriter progress) {
    this.out = out;
    this.progress = Progress.to(progress);
  }

  /**
   * Runs the studies.
   *
   * @param folder the output folder, created if missing
   * @param quick whether to judge fewer legs and run fewer frames
   * @param seed of the attack
   * @param out receives the figures
   * @param progress receives progress lines
   * @return the number of figures that miss their targets
   */
  public static long run(
      Path folder, boolean quick, long seed, PrintWriter out, PrintWriter progress)
      throws IOException {
    Files.createDirectories(folder);
    out.println(MachineSummary.line(MachineSummary.facts()) + ", seed " + seed);
    ElasticRun run = new ElasticRun(out, progress);
    run.measure(folder, quick, seed);
    StudyTable.ELASTIC.write(folder, run.figures, RigidFigure::cells);
    return RigidRun.printMissed(run.figures, out);
  }

  private void measure(Path folder, boolean quick, long seed) throws IOException {
    progress.accept("formulas");
    add(new FormulaStudy(quick).figures());
    progress.accept("times of frames");
    ElasticTimes times = new ElasticTimes(quick ? 10_000 : 100_000, quick ? 40 : 200);
    add(times.frameFigures());
    progress.accept("times of frames beside updates in another thread");
    SessionTimes beside = new SessionTimes(quick ? 20_000 : 100_000);
    add(beside.figures(Softness.USUAL));
    add(beside.figures(Softness.USUAL.withSmooth()));
    progress.accept("times of updates");
    List<RigidFigure> updates = times.updateFigures();
    add(updates);
    ElasticPlots.plotUpdates(folder.resolve("elastic-updates.png"), updates);
    progress.accept("presses and slides");
    PressStudy press = new PressStudy();
    add(press.steps());
    ElasticPlots.plotTime(folder.resolve("elastic-time.png"), press);
    List<RigidFigure> finer = press.finer();
    add(finer);
    ElasticPlots.plotDepth(folder.resolve("elastic-depth.png"), finer);
    add(press.directions());
    progress.accept("work");
    add(new WorkStudy().figures());
    progress.accept("rest");
    add(new RestStudy().figures());
    progress.accept("attack");
    ElasticAttack attack = new ElasticAttack(seed);
    attack.attack(UpdatePace.USUAL, 50_000, 1_000_000);
    if (!quick) {
      attack.attack(UpdatePace.RARE, 10_000_000, 100_000_000);
    }
    add(attack.figures());
    progress.accept("attack of contacts in a window");
    ElasticAttack sharp = new ElasticAttack(seed, true);
    sharp.attack(UpdatePace.USUAL, quick ? 10_000 : 50_000, 1_000_000);
    add(sharp.figures());
  }

  private void add(List<RigidFigure> more) {
    figures.addAll(more);
    RigidRun.print(more, out);
  }
}
