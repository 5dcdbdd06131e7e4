package org.palpate.benchmarks.jitter;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Properties;
import org.HdrHistogram.Histogram;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.benchmarks.jitter.experiment.BackgroundLoad;
import org.palpate.benchmarks.jitter.experiment.Experiment;
import org.palpate.benchmarks.jitter.experiment.JitMode;
import org.palpate.benchmarks.jitter.experiment.Scheduling;
import org.palpate.benchmarks.jitter.experiment.Workload;
import org.palpate.benchmarks.jitter.trace.Cause;
import org.palpate.benchmarks.jitter.trace.ExperimentFolder;
import org.palpate.benchmarks.jitter.trace.Samples;
import org.palpate.benchmarks.report.Row;
import org.palpate.realtime.WaitKind;

/** Evaluates the files of a control experiment that the test writes. */
class ExperimentResultTest {
  private static final long MILLI = 1_000_000;
  private static final int FRAMES = 1_000;
  private static final int LATE = 500;
  private static final Experiment CONTROL =
      new Experiment(
          null,
          null,
          WaitKind.HYBRID,
          Scheduling.FIFO,
          Workload.EMPTY,
          BackgroundLoad.NONE,
          JitMode.DEFAULT,
          0,
          1_000,
          1,
          0);

  @TempDir private Path folder;

  /** Writes frames that are n us late, of which one lost 12 ms to the hypervisor. */
  private ExperimentResult evaluated() throws IOException {
    ExperimentFolder files = new ExperimentFolder(folder);
    Samples samples = new Samples(FRAMES);
    long due = 7_000 * MILLI;
    for (int n = 0; n < FRAMES; n++) {
      long late = n == LATE ? 12 * MILLI : n % 100 * 1_000L;
      samples.add(due, due + late, due + late + 20_000, 0, 0, 0);
      due += n == LATE ? 13 * MILLI : MILLI;
    }
    samples.write(files.samples());
    long before = 7_490 * MILLI;
    Files.writeString(
        files.machine(),
        "nanos,stolen_nanos,busy_nanos,idle_nanos\n"
            + ("0,0,0,0\n" + before + ",0,60000000,30000000\n")
            + (7_520 * MILLI + ",10000000,60000000,30000000\n"));
    Properties outcome = new Properties();
    outcome.setProperty("allocated_bytes", "2500000");
    outcome.setProperty("start_to_steady_millis", "321");
    files.writeOutcome(outcome);
    return ExperimentResult.of(CONTROL, files);
  }

  @Test
  void everyFigureOfAnExperimentStandsInItsColumn() throws IOException {
    Map<String, Object> row = Row.of(ResultRows.columns(), ResultRows.cells(evaluated()));
    assertEquals("c++", row.get("runtime"));
    assertEquals("hybrid", row.get("wait"));
    assertEquals("fifo", row.get("scheduling"));
    assertEquals((long) FRAMES, row.get("frames"));
    assertEquals(12L, row.get("omitted"));
    assertEquals(1L, row.get("over_10_ms"));
    assertEquals(1L, row.get("over_1_5_ms"));
    assertEquals(2.5, row.get("frame_allocated_mb"));
    assertEquals(321.0, row.get("start_to_steady_ms"));
    assertEquals(0.1, row.get("machine_stolen"));
    assertEquals(0.6, row.get("machine_busy"));
    assertEquals(0L, row.get("pauses"));
    assertEquals("steal", row.get("worst_cause"));
    assertNear(50, row.get("late_p50_us"));
    assertNear(12_000, row.get("late_max_us"));
    assertNear(20, row.get("work_p50_us"));
    assertNear(20, row.get("work_max_us"));
  }

  private static void assertNear(double expected, Object actual) {
    assertEquals(expected, (double) actual, 2e-3 * expected);
  }

  @Test
  void theWorstFramesComeFirstAndTheTimelineBeginsAtTheFirstDeadline() throws IOException {
    ExperimentResult result = evaluated();
    assertEquals(10, result.causes().size());
    Cause worst = result.causes().get(0);
    assertEquals(LATE, worst.frame());
    assertEquals(Cause.Kind.STEAL, worst.kind());
    assertEquals(Cause.Kind.OUTSIDE, result.causes().get(1).kind());
    assertEquals(99_000, result.causes().get(1).latenessNanos());
    assertEquals(7_000 * MILLI, result.firstDueNanos());
    assertEquals(0.5, result.timeline().seconds().get(400), 0.002);
    assertEquals("", result.outcome("never reported"));
  }

  @Test
  void percentilesAreInMicrosecondsUnderTheirNames() {
    Histogram histogram = new Histogram(3);
    for (int n = 1; n <= 100_000; n++) {
      histogram.recordValue(n * 100L);
    }
    Map<String, Object> values = ResultRows.percentiles(histogram);
    double[] expected = {5_000, 9_000, 9_900, 9_990, 9_999, 9_999.9, 10_000};
    String[] names = {"p50", "p90", "p99", "p99_9", "p99_99", "p99_999", "max"};
    for (int n = 0; n < names.length; n++) {
      assertNear(expected[n], values.get(names[n]));
    }
    assertEquals(names.length, values.size());
  }
}
