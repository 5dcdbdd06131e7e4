package org.palpate.benchmarks.rigid;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import org.palpate.benchmarks.moving.MovingBodiesStudy;
import org.palpate.benchmarks.report.MachineSummary;
import org.palpate.benchmarks.report.Progress;
import org.palpate.benchmarks.report.StudyTable;

/** Runs all studies of rigid tools, prints their figures, and writes a table and plots. */
public final class RigidRun {
  private static final String MOVING = "moving";
  private static final String HOSTILE = "hostile frames";

  private final boolean quick;
  private final long seed;
  private final PrintWriter out;
  private final Consumer<String> progress;
  private final List<RigidFigure> figures = new ArrayList<>();

  private RigidRun(boolean quick, long seed, PrintWriter out, PrintWriter progress) {
    this.quick = quick;
    this.seed = seed;
    this.out = out;
    this.progress = Progress.to(progress);
  }

  /**
   * Runs the studies.
   *
   * @param folder the output folder, created if missing
   * @param quick whether to use fewer frames, insertions and legs
   * @param seed of scenes, hands and cuts
   * @param out receives the figures
   * @param progress receives progress lines
   * @return the number of figures that miss their targets
   */
  public static long run(
      Path folder, boolean quick, long seed, PrintWriter out, PrintWriter progress)
      throws IOException, InterruptedException {
    Files.createDirectories(folder);
    RigidRun run = new RigidRun(quick, seed, out, progress);
    out.println(MachineSummary.line(MachineSummary.facts()) + ", seed " + seed);
    run.measure();
    StudyTable.RIGID.write(folder, run.figures, RigidFigure::cells);
    RigidPlots.write(folder, run.figures);
    return printMissed(run.figures, out);
  }

  /** Prints and returns the number of figures that miss their targets. */
  public static long printMissed(List<RigidFigure> figures, PrintWriter out) {
    long missed = figures.stream().filter(f -> f.verdict().equals("missed")).count();
    long targets = figures.stream().filter(RigidFigure::hasTarget).count();
    out.println(missed + " of " + targets + " targets missed");
    out.flush();
    return missed;
  }

  private void measure() throws IOException, InterruptedException {
    progress.accept("frame times");
    add(times());
    progress.accept("forces");
    add(new ForceStudy(quick ? 1_000 : 20_000, seed).figures());
    progress.accept("methods side by side");
    add(new PeerStudy(quick ? 1_000 : 10_000, seed).figures());
    progress.accept("slides");
    add(new SlideWatchStudy(quick ? 500 : 5_000, seed).figures());
    progress.accept("pegs");
    add(new PegStudy(quick ? 1 : 8, seed).figures());
    progress.accept("halves");
    add(new HalvesStudy(seed).figures());
    progress.accept("guarantee");
    add(guarantee().figures());
    progress.accept("moving bodies");
    add(movingBodies());
  }

  private List<RigidFigure> movingBodies() {
    MovingBodiesStudy.Result result =
        new MovingBodiesStudy(quick ? 100_000 : 10_000_000, 1_000, seed, progress).run();
    return List.of(
        noneOf("legs that touch a solid", result.touching()),
        countOf("legs judged", result.legs()),
        noneOf("broken chains", result.broken()),
        noneOf("voxels that overlap", result.overlapping()),
        countOf("pairs of bodies compared", result.compared()),
        countOf("frames", result.frames()),
        countOf("motions of bodies", result.motions()),
        countOf("pushes of the tool", result.pushes()),
        countOf("bodies held back", result.heldBack()),
        countOf("frames with a body in hand", result.holds()),
        countOf("frames with contact", result.contacts()));
  }

  private static RigidFigure noneOf(String name, long count) {
    return new RigidFigure(MOVING, HOSTILE, name, (double) count, "", 0);
  }

  private static RigidFigure countOf(String name, long count) {
    return RigidFigure.of(MOVING, HOSTILE, name, (double) count, "");
  }

  private GuaranteeStudy guarantee() {
    return quick
        ? new GuaranteeStudy(10_000_000, 100_000, 2_000, seed, progress)
        : new GuaranteeStudy(1_000_000_000, 10_000_000, 100_000, seed, progress);
  }

  private List<RigidFigure> times() throws IOException, InterruptedException {
    List<List<FrameTimer.Times>> forks = new ArrayList<>();
    int forkCount = quick ? 1 : 3;
    for (int fork = 0; fork < forkCount; fork++) {
      forks.add(FrameTimer.inProcessOfItsOwn(quick ? 2_000 : 10_000, quick ? 1_000 : 20_000));
    }
    List<RigidFigure> rows = new ArrayList<>();
    List<TimedCondition> conditions = TimedCondition.all();
    List<FrameTimer.Times> medians = FrameTimer.medians(forks);
    for (int n = 0; n < conditions.size(); n++) {
      rows.addAll(conditions.get(n).figures(medians.get(n)));
    }
    return rows;
  }

  private void add(List<RigidFigure> more) {
    figures.addAll(more);
    print(more, out);
  }

  /** Prints a line for each figure. */
  public static void print(List<RigidFigure> figures, PrintWriter out) {
    for (RigidFigure figure : figures) {
      String target =
          figure.hasTarget()
              ? "at most " + shortText(figure.target()) + ": " + figure.verdict()
              : "";
      out.printf(
          Locale.ROOT,
          "%-10s %-36s %-32s %10s %-8s %s%n",
          figure.study(),
          figure.condition(),
          figure.name(),
          shortText(figure.value()),
          figure.unit(),
          target);
    }
    out.flush();
  }

  private static String shortText(double value) {
    return String.format(Locale.ROOT, value == Math.rint(value) ? "%.0f" : "%.3f", value);
  }
}
