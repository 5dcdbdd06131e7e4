package org.palpate.benchmarks.stability;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.palpate.benchmarks.report.Progress;
import org.palpate.benchmarks.report.StudyTable;
import org.palpate.benchmarks.stability.StabilityStudy.TheoryRow;
import org.palpate.benchmarks.stability.Trial.SolverChoice;
import org.palpate.geometry.GridMetric;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.reference.BorderVoxels;
import org.palpate.proxy.reference.DotSolver;
import org.palpate.proxy.reference.PaperSolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.raycast.SampledRayCaster;

/** Runs the study and writes tables and plots to a folder. */
public final class StabilityRun {
  private static final double WANTED_MARGIN = 2;
  private static final long SEED = 7;

  /** 10^8 frames for each solver. */
  private static final int ROUNDS = 1000;

  private static final int QUICK_ROUNDS = 30;

  private StabilityRun() {}

  /** Returns the compared solvers. */
  public static List<SolverChoice> solvers() {
    return List.of(
        new SolverChoice("guarded", GuardedSolver::new),
        new SolverChoice("smooth", SmoothSolver::new),
        new SolverChoice("paper", StabilityRun::paper),
        new SolverChoice("dot", StabilityRun::dot));
  }

  private static ProxySolver paper(GridMetric metric, double maxStepMm) {
    return new PaperSolver(new SampledRayCaster(1), metric, maxStepMm, BorderVoxels.onTheFly());
  }

  private static ProxySolver dot(GridMetric metric, double maxStepMm) {
    return new DotSolver(new SampledRayCaster(1), metric, maxStepMm, BorderVoxels.onTheFly());
  }

  /**
   * Runs the study.
   *
   * @param folder the output folder, created if missing
   * @param quick whether to use fewer values in each sweep
   * @param out receives the results
   * @param progress receives progress lines
   * @return the least margin of the default stiffness over the sweep, by device
   */
  public static Map<String, Double> run(
      Path folder, boolean quick, PrintWriter out, PrintWriter progress) throws IOException {
    Files.createDirectories(folder);
    StabilityStudy study = new StabilityStudy(quick, solvers(), Progress.to(progress));
    reportTheory(folder, study.theory(), out);
    Map<String, Double> margins = reportDevices(folder, study.devices(), out);
    reportShapes(folder, study.shapes(), out);
    List<MarginRow<HeldTrial>> tools = new ArrayList<>(study.tools());
    tools.addAll(study.heldTools());
    tools.addAll(study.fragments());
    reportTools(folder, tools, out);
    reportFeel(folder, study.feel(), out);
    reportCarving(folder, study.carving(), out);
    reportLongRuns(quick, out, progress);
    out.flush();
    return margins;
  }

  private static void reportTheory(Path folder, List<TheoryRow> rows, PrintWriter out)
      throws IOException {
    StudyTable.STABILITY_THEORY.write(folder, rows, TheoryRow::cells);
    List<Double> dampings = rows.stream().map(TheoryRow::damping).distinct().toList();
    for (double damping : dampings) {
      String name = "stability-theory-b" + damping + ".png";
      StabilityPlots.plotTheory(folder.resolve(name), rows, damping);
    }
    double least = rows.stream().mapToDouble(row -> row.largest() / row.passive()).min().orElse(0);
    out.printf(
        Locale.ROOT, "theory: model over passive bound, least of %d: %.2f%n", rows.size(), least);
  }

  private static Map<String, Double> reportDevices(
      Path folder, List<MarginRow<Trial>> rows, PrintWriter out) throws IOException {
    StudyTable.STABILITY_DEVICES.write(folder, rows, MarginRow::cells);
    Map<String, Double> margins = StabilityStudy.leastMargins(rows);
    StabilityPlots.plotMargins(folder.resolve("stability-devices.png"), margins);
    margins.forEach(
        (device, margin) ->
            out.printf(
                Locale.ROOT,
                "device %s: least margin of the default stiffness %.2f%s%n",
                device,
                margin,
                margin < WANTED_MARGIN ? " (below 2)" : ""));
    return margins;
  }

  private static void reportTools(Path folder, List<MarginRow<HeldTrial>> rows, PrintWriter out)
      throws IOException {
    report(folder, StudyTable.STABILITY_TOOLS, rows, StabilityRun::condition, out);
  }

  private static void reportFeel(Path folder, List<MarginRow<FeelTrial>> rows, PrintWriter out)
      throws IOException {
    report(folder, StudyTable.STABILITY_FEEL, rows, StabilityRun::feel, out);
  }

  /** Writes a table of trials whose energy is measured, and a line for each condition. */
  private static <T extends EnergyTrial> void report(
      Path folder,
      StudyTable table,
      List<MarginRow<T>> rows,
      Function<T, String> condition,
      PrintWriter out)
      throws IOException {
    Map<MarginRow<T>, Double> given = new LinkedHashMap<>();
    rows.forEach(row -> given.put(row, row.trial().givenMillijoule(row.defaultStiffness())));
    table.write(folder, rows, row -> energyCells(row, given.get(row)));
    Map<String, List<MarginRow<T>>> conditions =
        rows.stream()
            .collect(
                Collectors.groupingBy(
                    row -> condition.apply(row.trial()), LinkedHashMap::new, Collectors.toList()));
    conditions.forEach(
        (name, own) ->
            out.printf(
                Locale.ROOT,
                "%s: least margin of the default stiffness %.2f, unstable at the default in %d of"
                    + " %d, gives at most %.3f mJ: %s%n",
                name,
                own.stream().mapToDouble(MarginRow::margin).min().orElse(0),
                own.stream().filter(row -> !row.atDefault().stable()).count(),
                own.size(),
                own.stream().mapToDouble(given::get).max().orElse(0),
                own.stream().allMatch(row -> row.trial().isPassive(given.get(row)))
                    ? "passive"
                    : "active"));
  }

  /** Returns the cells of a row whose energy is measured. */
  static <T extends EnergyTrial> List<Object> energyCells(
      MarginRow<T> row, double givenMillijoule) {
    List<Object> cells = new ArrayList<>(row.cells());
    cells.add(givenMillijoule);
    cells.add(row.trial().isPassive(givenMillijoule) ? "passive" : "active");
    return cells;
  }

  private static String feel(FeelTrial trial) {
    return String.format(
        Locale.ROOT, "feel %s at %.0f Hz", trial.feel().name(), trial.sampling().rateHz());
  }

  private static void reportCarving(Path folder, List<CarveTrial.Result> results, PrintWriter out)
      throws IOException {
    StudyTable.STABILITY_CARVE.write(folder, results, CarveTrial.Result::cells);
    Map<Double, List<CarveTrial.Result>> byStiffness =
        results.stream()
            .collect(
                Collectors.groupingBy(
                    CarveTrial.Result::overDefault, LinkedHashMap::new, Collectors.toList()));
    byStiffness.forEach(
        (overDefault, own) ->
            out.printf(
                Locale.ROOT,
                "carving at %.0f times the default stiffness: unstable in %d of %d, longest way"
                    + " back %.3f mm%n",
                overDefault,
                own.stream().filter(result -> !result.outcome().stable()).count(),
                own.size(),
                own.stream().mapToDouble(r -> r.outcome().excursionMm()).max().orElse(0)));
  }

  private static String condition(HeldTrial trial) {
    return String.format(
        Locale.ROOT,
        "%s, %.0f mm, with %s, grip %s, at %.0f Hz",
        trial.heldName(),
        trial.lengthMm(),
        trial.device().name(),
        trial.grip().name(),
        trial.sampling().rateHz());
  }

  private static void reportLongRuns(boolean quick, PrintWriter out, PrintWriter progress) {
    for (SolverChoice solver : solvers().subList(0, 2)) {
      LongRun run = new LongRun(solver, SEED);
      LongRun.Result result =
          run.run(
              quick ? QUICK_ROUNDS : ROUNDS,
              line -> Progress.to(progress).accept(line + " by " + solver.name()));
      out.printf(
          Locale.ROOT,
          "long run by %s: %d frames, %d in contact, %d rounds that differ from the second, %d that"
              + " allocate, %.0f ns per frame at first and %.0f at last (seed %d)%n",
          solver.name(),
          result.frames(),
          result.contactFrames(),
          result.differingRounds(),
          result.allocatingRounds(),
          result.firstNanosPerFrame(),
          result.lastNanosPerFrame(),
          SEED);
    }
  }

  private static void reportShapes(Path folder, List<MarginRow<Trial>> rows, PrintWriter out)
      throws IOException {
    StudyTable.STABILITY_SHAPES.write(folder, rows, MarginRow::cells);
    for (String device :
        rows.stream().map(row -> row.trial().device().name()).distinct().toList()) {
      String name = "stability-shapes-" + device.toLowerCase(Locale.ROOT) + ".png";
      StabilityPlots.plotExcursion(folder.resolve(name), rows, device);
    }
    for (MarginRow<Trial> row : rows) {
      out.printf(
          Locale.ROOT,
          "shape %s by %s with %s: margin %.2f, excursion %.4f mm, energy %.3f mJ, rise %.2f"
              + " N/ms%n",
          row.trial().shape().name(),
          row.trial().solver().name(),
          row.trial().device().name(),
          row.margin(),
          row.atDefault().excursionMm(),
          row.atDefault().energyBackMillijoule(),
          row.atDefault().riseNewtonPerMs());
    }
  }
}
