package org.palpate.benchmarks.speed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.palpate.benchmarks.report.Row;
import org.palpate.benchmarks.report.StudyTable;

class SpeedRowTest {
  private static SpeedRow row(double bytes) {
    Map<String, String> condition = new LinkedHashMap<>();
    condition.put("way", "free");
    condition.put("depth", "3");
    return new SpeedRow(
        "response", "run", condition, "ns/op", List.of(20.0, 30.0, 50.0, 400.0), bytes);
  }

  @Test
  void everyFigureOfATimeStandsInItsColumn() {
    for (StudyTable table :
        List.of(StudyTable.SPEED, StudyTable.TABLE1, StudyTable.SKIPS, StudyTable.SCALE)) {
      assertEquals(
          Map.of(
              "group",
              "response",
              "benchmark",
              "run",
              "condition",
              "free, 3",
              "unit",
              "ns/op",
              "median",
              40.0,
              "least",
              20.0,
              "greatest",
              400.0,
              "iterations",
              4,
              "bytes_per_op",
              16.0),
          Row.of(table, row(16).cells()));
    }
  }

  @Test
  void bytesThatWereNotMeasuredAreLeftEmpty() {
    assertEquals("", Row.of(StudyTable.SPEED, row(Double.NaN).cells()).get("bytes_per_op"));
    assertFalse(row(Double.NaN).allocatesNothing());
  }

  @Test
  void lessThanHalfAByteIsTheBenchmarksOwn() {
    assertTrue(row(0.49).allocatesNothing());
    assertFalse(row(0.5).allocatesNothing());
  }
}
