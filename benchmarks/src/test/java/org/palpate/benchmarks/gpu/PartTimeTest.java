package org.palpate.benchmarks.gpu;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.palpate.benchmarks.report.Row;
import org.palpate.benchmarks.report.StudyTable;

class PartTimeTest {
  @Test
  void everyPercentileStandsInItsColumn() {
    assertEquals(
        Map.of(
            "device",
            "cpu",
            "points",
            1_000L,
            "part",
            "judge",
            "frames",
            500L,
            "least_us",
            0.5,
            "p50_us",
            1.0,
            "p99_us",
            2.0,
            "p99_9_us",
            3.0,
            "max_us",
            4.0),
        Row.of(StudyTable.GPU, new PartTime("cpu", 1_000, "judge", 500, 0.5, 1, 2, 3, 4).cells()));
  }

  @Test
  void aPartRunsForItsFramesAfterAWarmUpOfATenth() {
    int[] runs = new int[1];
    PartTime time = PartTime.measure("cpu", 10, "count", 200, () -> runs[0]++);
    assertEquals(221, runs[0]);
    assertEquals(200, time.frames());
    assertTrue(time.p50() <= time.p99() && time.p99() <= time.p999(), time.toString());
    assertTrue(time.p999() <= time.max() && time.least() <= time.p50(), time.toString());
  }

  @Test
  void aSlowFrameInTwoHundredShowsInTheLargestTimesAndNotInTheMedian() {
    int[] runs = new int[1];
    PartTime time =
        PartTime.measure(
            "cpu",
            10,
            "one slow frame",
            200,
            () -> {
              long until = System.nanoTime() + (runs[0]++ == 100 ? 300_000_000L : 0);
              while (System.nanoTime() < until) {
                Thread.onSpinWait();
              }
            });
    assertTrue(time.max() >= 300_000, time.toString());
    assertTrue(time.p999() == time.max(), time.toString());
    assertTrue(time.p50() < 100_000, time.toString());
  }
}
