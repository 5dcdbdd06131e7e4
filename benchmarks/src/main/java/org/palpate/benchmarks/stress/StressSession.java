package org.palpate.benchmarks.stress;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.palpate.io.file.AtomicFile;
import org.palpate.proxy.exact.GuardedSolver;

/**
 * {@code palpate bench --stress}: a run that says how far it is, keeps its totals in a folder, goes
 * on from them, and leaves the smallest case of what failed.
 */
public final class StressSession {
  private static final long NANOS_BETWEEN_LINES = 5_000_000_000L;
  private static final int BASELINE_CASES = 100;
  private static final int STEP_CASES = 1000;
  private static final int JUMPS = 100_000;

  private final Path folder;
  private final long seed;
  private final Attacked attacked;
  private final PrintWriter progress;
  private long lastLineNanos = System.nanoTime();

  /** Which solver is attacked. */
  public enum Attacked {
    GUARDED,
    SMOOTH;

    private SolverFactory maker() {
      return this == GUARDED ? GuardedSolver::new : SolverFactory.SMOOTH;
    }

    /** As on the command line. */
    @Override
    public String toString() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /** A session that keeps its files in a folder, which is made where it is not there. */
  public StressSession(Path folder, long seed, Attacked attacked, PrintWriter progress) {
    this.attacked = attacked;
    this.folder = folder;
    this.seed = seed;
    this.progress = progress;
  }

  /**
   * Runs until so many frames of this seed are done in all, those of earlier runs counted.
   *
   * @return the totals
   * @throws FailedCaseException where a promise was broken; the case lies in the folder
   */
  public StressTotals run(long frames) throws IOException {
    Files.createDirectories(folder);
    Path file = folder.resolve("stress-" + attacked + "-" + seed + ".properties");
    StressTotals totals = StressTotals.read(file);
    try {
      FailedCase failed =
          new StressRun(seed, attacked.maker())
              .untilFrames(totals, frames, now -> tell(now, frames, file));
      totals.write(file);
      if (failed != null) {
        Path place = folder.resolve("failed-" + failed.caseSeed());
        failed.write(place, attacked.toString());
        throw new FailedCaseException(failed.summary(), place);
      }
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
    return totals;
  }

  private void tell(StressTotals totals, long frames, Path file) {
    if (System.nanoTime() - lastLineNanos < NANOS_BETWEEN_LINES) {
      return;
    }
    lastLineNanos = System.nanoTime();
    progress.printf(
        Locale.ROOT,
        "%.1f %%: %d frames, %d legs, no fault%n",
        100.0 * totals.frames / frames,
        totals.frames,
        totals.legs);
    progress.flush();
    try {
      totals.write(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Runs whole frames, with a bad device, edits, and solvers that take turns.
   *
   * @return a line that tells what was done
   * @throws FailedCaseException where a promise was broken
   */
  public String attackFrames(long frames) throws FailedCaseException {
    FrameAttack attack = new FrameAttack();
    String fault = attack.untilFrames(seed, frames);
    if (fault != null) {
      throw new FailedCaseException(fault, folder);
    }
    return String.format(
        Locale.ROOT,
        "whole frames: %d, %d legs, %d edits, set free %d times, 0 violations",
        attack.frames(),
        attack.legs(),
        attack.edits(),
        attack.freed());
  }

  /**
   * Prints what work frames were, in steps, as Markdown, and leaves it as a table in the folder.
   */
  public void tellSteps(PrintWriter out) throws IOException {
    StringBuilder csv = new StringBuilder("hand,frames,median_steps,p99_steps,worst_steps\n");
    out.println("| steps a frame, " + attacked + " | frames | median | p99 | worst |");
    out.println("| --- | --- | --- | --- | --- |");
    for (WorkStudy.Row row : new WorkStudy(attacked, seed, STEP_CASES, JUMPS).rows()) {
      out.printf(
          Locale.ROOT,
          "| %s | %d | %d | %d | %d |%n",
          row.hand(),
          row.frames(),
          row.median(),
          row.p99(),
          row.worst());
      csv.append('"').append(row.hand()).append("\",").append(row.frames()).append(',');
      csv.append(row.median()).append(',').append(row.p99()).append(',').append(row.worst());
      csv.append('\n');
    }
    AtomicFile.write(folder.resolve("steps-" + attacked + "-" + seed + ".csv"), csv);
    out.flush();
  }

  /** Prints what other ways lose on the first cases of the seed. */
  public void printBaselines(PrintWriter out) {
    BaselineLosses losses = new BaselineLosses(seed);
    losses.run(BASELINE_CASES);
    losses.print(out);
  }

  /** A promise was broken. */
  public static final class FailedCaseException extends IOException {
    private static final long serialVersionUID = 1L;
    private final String summary;
    private final String place;

    FailedCaseException(String summary, Path place) {
      super(summary);
      this.summary = summary;
      this.place = place.toString();
    }

    public String summary() {
      return summary;
    }

    /** The folder of the case. */
    public String place() {
      return place;
    }
  }
}
