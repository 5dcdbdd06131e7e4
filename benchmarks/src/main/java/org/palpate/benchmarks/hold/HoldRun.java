package org.palpate.benchmarks.hold;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.palpate.benchmarks.SessionJvm;
import org.palpate.benchmarks.jitter.experiment.Experiment;
import org.palpate.benchmarks.jitter.experiment.ExperimentRunner;
import org.palpate.benchmarks.jitter.experiment.Scheduling;
import org.palpate.benchmarks.jitter.trace.Samples;
import org.palpate.benchmarks.report.MachineSummary;
import org.palpate.benchmarks.report.OwnProcess;
import org.palpate.benchmarks.report.Progress;
import org.palpate.benchmarks.report.StudyTable;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.benchmarks.rigid.RigidRun;
import org.palpate.realtime.WaitKind;
import org.palpate.volume.phantom.FracturePhantom;

/**
 * Measures sessions in which the hand holds a fragment, with a window and without, and beside them
 * the loop in C++. Prints the figures and writes a table.
 */
public final class HoldRun {
  private static final String FRAGMENTS = FracturePhantom.NAME + ":704:8:3";
  private static final String QUICK_FRAGMENTS = FracturePhantom.NAME + ":160:8";

  /** The wanted number of sample points of the fragment in hand. */
  private static final int POINTS = 20_000;

  private static final int ROUNDS = 3;
  private static final int CONTROL_SECONDS = 10;
  private static final int QUICK_CONTROL_SECONDS = 2;
  private static final double WARM_UP_SECONDS = 20;
  private static final double QUICK_WARM_UP_SECONDS = 3;
  private static final double SECONDS = 30;
  private static final double QUICK_SECONDS = 5;

  private final Path folder;
  private final boolean quick;
  private final PrintWriter out;
  private final Consumer<String> progress;
  private final List<RigidFigure> figures = new ArrayList<>();

  private HoldRun(Path folder, boolean quick, PrintWriter out, PrintWriter progress) {
    this.folder = folder;
    this.quick = quick;
    this.out = out;
    this.progress = Progress.to(progress);
  }

  /**
   * Runs sessions and control loops in turn. Needs a display.
   *
   * @param folder the output folder, created if missing
   * @param quick whether to run each once, for a shorter time and with a smaller bone
   * @param out receives the figures
   * @param progress receives progress lines
   * @return the number of figures that miss their targets
   */
  public static long run(Path folder, boolean quick, PrintWriter out, PrintWriter progress)
      throws IOException, InterruptedException {
    Files.createDirectories(folder);
    out.println(MachineSummary.line(MachineSummary.facts()));
    HoldRun run = new HoldRun(folder, quick, out, progress);
    for (int round = 1; round <= (quick ? 1 : ROUNDS); round++) {
      run.session(round, true);
      run.session(round, false);
      run.control(round);
    }
    StudyTable.HOLD.write(folder, run.figures, RigidFigure::cells);
    return RigidRun.printMissed(run.figures, out);
  }

  private void session(int round, boolean hasWindow) throws IOException, InterruptedException {
    String condition = (hasWindow ? "with a window" : "without a window") + ", round " + round;
    progress.accept("hold: " + condition);
    List<String> arguments =
        List.of(
            quick ? QUICK_FRAGMENTS : FRAGMENTS,
            Integer.toString(POINTS),
            Double.toString(quick ? QUICK_WARM_UP_SECONDS : WARM_UP_SECONDS),
            Double.toString(quick ? QUICK_SECONDS : SECONDS),
            Boolean.toString(hasWindow));
    List<String> lines = OwnProcess.lines(HoldSession.class, SessionJvm.flags(), arguments);
    add(condition, lines.stream().map(HoldFigures::parse).toList());
  }

  private void control(int round) throws IOException, InterruptedException {
    String condition = "C++, empty loop, round " + round;
    progress.accept("hold: " + condition);
    int seconds = quick ? QUICK_CONTROL_SECONDS : CONTROL_SECONDS;
    Experiment loop = Experiment.control(WaitKind.HYBRID, Scheduling.FIFO, seconds, round);
    ExperimentRunner runner = new ExperimentRunner(folder.toRealPath(), "");
    runner.folder(loop).invalidate();
    Optional<String> refusal = runner.run(loop);
    if (refusal.isPresent()) {
      progress.accept("hold: no loop in C++: " + refusal.get());
    } else {
      Samples samples = Samples.read(runner.folder(loop).samples());
      add(condition, HoldFigures.lateness(samples.latenessMicros()));
    }
  }

  private void add(String condition, List<RigidFigure> found) {
    List<RigidFigure> placed = found.stream().map(f -> HoldFigures.in(condition, f)).toList();
    figures.addAll(placed);
    RigidRun.print(placed, out);
  }
}
