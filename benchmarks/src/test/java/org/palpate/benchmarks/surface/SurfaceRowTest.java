package org.palpate.benchmarks.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.palpate.benchmarks.report.Row;
import org.palpate.benchmarks.report.StudyTable;

class SurfaceRowTest {
  @Test
  void everyFigureOfASurfaceStandsInItsColumn() {
    assertEquals(
        Map.ofEntries(
            Map.entry("data", "CThead"),
            Map.entry("voxels", 1L),
            Map.entry("triangles", 2L),
            Map.entry("vertices", 3L),
            Map.entry("cpu_s", 4.0),
            Map.entry("heap_bytes", 5L),
            Map.entry("card_bytes", 6L),
            Map.entry("coarse_triangles", 7L),
            Map.entry("coarse_cpu_s", 8.0),
            Map.entry("brick_median_ms", 9.0),
            Map.entry("brick_most_ms", 10.0)),
        Row.of(
            StudyTable.SURFACES, new SurfaceRow("CThead", 1, 2, 3, 4, 5, 6, 7, 8, 9, 10).cells()));
  }
}
