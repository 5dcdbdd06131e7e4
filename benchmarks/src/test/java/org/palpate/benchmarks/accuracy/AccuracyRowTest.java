package org.palpate.benchmarks.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.palpate.benchmarks.report.Row;
import org.palpate.benchmarks.report.StudyTable;

class AccuracyRowTest {
  private static AccuracyRow row(int edge, String spacing) {
    Accuracy accuracy = new Accuracy(1.5, 9.5, 0.25, 0.125, 1.01, 2.5, 7);
    return new AccuracyRow("guarded", "torus", edge, spacing, 3, 0.5, accuracy, 812);
  }

  @Test
  void everyErrorStandsInItsColumn() {
    assertEquals(
        Map.ofEntries(
            Map.entry("shape", "torus"),
            Map.entry("edge_mm", 64),
            Map.entry("spacing_mm", "1:1:2"),
            Map.entry("depth_voxels", 3.0),
            Map.entry("speed_voxels", 0.5),
            Map.entry("solver", "guarded"),
            Map.entry("angle_rms_deg", 1.5),
            Map.entry("angle_worst_deg", 9.5),
            Map.entry("height_mean_mm", 0.25),
            Map.entry("height_std_mm", 0.125),
            Map.entry("lag", 1.01),
            Map.entry("force_change", 2.5),
            Map.entry("lost_frames", 7.0),
            Map.entry("ns_per_frame", 812.0)),
        Row.of(StudyTable.ACCURACY, row(64, "1:1:2").cells()));
  }

  @Test
  void aSeriesNamesTheSizeAndTheSpacingOnlyIfTheyAreUnusual() {
    assertEquals("guarded", row(192, "1:1:1").series());
    assertEquals("guarded, voxels of 1:1:2", row(192, "1:1:2").series());
    assertEquals("guarded, 256 mm", row(256, "1:1:1").series());
  }
}
