package org.palpate.benchmarks.sync;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import org.HdrHistogram.Histogram;
import org.junit.jupiter.api.Test;
import org.palpate.benchmarks.report.Row;
import org.palpate.benchmarks.report.StudyTable;

class SyncRowTest {
  /** Records 1 to 1,000 units, each once. */
  private static Histogram upToAThousand(long unitNanos) {
    Histogram histogram = new Histogram(3);
    for (int n = 1; n <= 1_000; n++) {
      histogram.recordValue(n * unitNanos);
    }
    return histogram;
  }

  @Test
  void workAndPeriodHaveTheirOwnPercentilesInMicroseconds() {
    SyncRow row =
        new SyncRow(SyncMethod.PAPER, 2, upToAThousand(1_000), upToAThousand(3_000), 77, 0.5);
    Map<String, Object> cells = Row.of(StudyTable.SYNC, row.cells());
    assertEquals("paper, synchronized", cells.get("way"));
    assertEquals(2, cells.get("round"));
    assertEquals(2_000.0, cells.get("rate_hz"), "1,000 frames in half a second");
    assertNear(500, cells.get("work_p50_us"));
    assertNear(990, cells.get("work_p99_us"));
    assertNear(999, cells.get("work_p99_9_us"));
    assertNear(1_000, cells.get("work_max_us"));
    assertNear(1_500, cells.get("period_p50_us"));
    assertNear(2_970, cells.get("period_p99_us"));
    assertNear(2_997, cells.get("period_p99_9_us"));
    assertNear(3_000, cells.get("period_max_us"));
    assertEquals(77L, cells.get("redraws"));
  }

  /** The histogram keeps three digits. */
  private static void assertNear(double expected, Object actual) {
    assertEquals(expected, (double) actual, 1e-3 * expected);
  }

  @Test
  void theCostOfAWriteStandsInItsColumn() {
    assertEquals(
        Map.of(
            "way",
            "wait-free",
            "changed_ns",
            21.5,
            "unchanged_ns",
            4.5,
            "p99_9_ns",
            80L,
            "max_ns",
            900L),
        Row.of(StudyTable.SYNC_WRITES, new WriteCost.Row("wait-free", 21.5, 4.5, 80, 900).cells()));
  }
}
