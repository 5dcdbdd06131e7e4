package org.palpate.benchmarks.stress;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.palpate.benchmarks.report.StudyTable;
import org.palpate.benchmarks.report.TableFile;
import org.palpate.proxy.exact.GuardedSolver;

/**
 * The session of {@code palpate bench --stress}. It reports its progress, keeps its totals in a
 * folder, continues from them, and saves the smallest case of a failure.
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

  /** The attacked solver. */
  public enum Attacked {
    /** The guarded solver, with all its promises. */
    GUARDED,
    /** The smooth solver, with its legs. */
    SMOOTH;

    private SolverFactory factory() {
      return this == GUARDED ? GuardedSolver::new : SolverFactory.SMOOTH;
    }

    /** Returns the name on the command line. */
    @Override
    public String toString() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /** Creates a session that keeps its files in a folder, which is created if missing. */
  public StressSession(Path folder, long seed, Attacked attacked, PrintWriter progress) {
    this.attacked = attacked;
    this.folder = folder;
    this.seed = seed;
    this.progress = progress;
  }

  /**
   * Runs until a total number of frames of this seed is reached, earlier runs included.
   *
   * @return the totals
   * @throws FailedCaseException if a promise is broken; the folder then contains the case
   */
  public StressTotals run(long frames) throws IOException {
    Files.createDirectories(folder);
    Path file = folder.resolve("stress-" + attacked + "-" + seed + ".properties");
    StressTotals totals = StressTotals.read(file);
    try {
      FailedCase failed =
          new StressRun(seed, attacked.factory())
              .untilFrames(totals, frames, now -> reportProgress(now, frames, file));
      totals.write(file);
      if (failed != null) {
        Path caseFolder = folder.resolve("failed-" + failed.caseSeed());
        failed.write(caseFolder, attacked.toString());
        throw new FailedCaseException(failed.summary(), caseFolder);
      }
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
    return totals;
  }

  private void reportProgress(StressTotals totals, long frames, Path file) {
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
   * Runs whole frames with a faulty device, edits and changing solvers.
   *
   * @return a line with the totals
   * @throws FailedCaseException if a promise is broken
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

  /** Prints the work of frames in work units as Markdown, and writes it as a table. */
  public void printWork(PrintWriter out) throws IOException {
    List<WorkStudy.Row> rows = new WorkStudy(attacked, seed, STEP_CASES, JUMPS).rows();
    out.println("| work units a frame, " + attacked + " | frames | median | p99 | worst |");
    out.println("| --- | --- | --- | --- | --- |");
    for (WorkStudy.Row row : rows) {
      out.printf(
          Locale.ROOT,
          "| %s | %d | %d | %d | %d |%n",
          row.hand(),
          row.frames(),
          row.median(),
          row.p99(),
          row.worst());
    }
    Path file = folder.resolve("steps-" + attacked + "-" + seed + ".csv");
    TableFile.write(file, StudyTable.STEPS.columns(), rows, WorkStudy.Row::cells);
    out.flush();
  }

  /** Prints the losses of other methods on the first cases of the seed. */
  public void printBaselines(PrintWriter out) {
    BaselineLosses losses = new BaselineLosses(seed);
    losses.run(BASELINE_CASES);
    losses.print(out);
  }

  /** A promise is broken. */
  public static final class FailedCaseException extends IOException {
    private static final long serialVersionUID = 1L;
    private final String summary;
    private final String caseFolder;

    FailedCaseException(String summary, Path caseFolder) {
      super(summary);
      this.summary = summary;
      this.caseFolder = caseFolder.toString();
    }

    /** Returns a description of the case. */
    public String summary() {
      return summary;
    }

    /** Returns the folder of the case. */
    public String caseFolder() {
      return caseFolder;
    }
  }
}
