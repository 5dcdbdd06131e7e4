package org.palpate.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class GridMetricTest {
  @Test
  void measuresInMillimetres() {
    GridMetric metric = GridMetric.of(new Vec3(2, 3, 0.5));
    assertEquals(4 + 36 + 4, metric.squaredDistance(1, 5, 2, 2, 3, 6));
    assertEquals(5, metric.distance(0, 0, 9, 2, -1, 9));
  }

  @ParameterizedTest
  @CsvSource({"1, 2, 3", "3, 1, 2", "2, 3, 1"})
  void findsTheShortestEdgeAlongEachAxis(double x, double y, double z) {
    assertEquals(1, new GridMetric(x, y, z).shortestEdgeMm());
  }

  @Test
  void takesEdgesFromATrillionthToATrillionMillimetres() {
    assertTrue(GridMetric.isValidSpacing(1e-12));
    assertTrue(GridMetric.isValidSpacing(1e12));
    for (double wrong : new double[] {0, -1, 0.99e-12, 1.01e12, Double.NaN}) {
      assertFalse(GridMetric.isValidSpacing(wrong));
      assertThrows(IllegalArgumentException.class, () -> new GridMetric(wrong, 1, 1));
      assertThrows(IllegalArgumentException.class, () -> new GridMetric(1, wrong, 1));
      Exception e = assertThrows(IllegalArgumentException.class, () -> new GridMetric(1, 1, wrong));
      assertTrue(e.getMessage().endsWith("spacingZ=" + wrong), e.getMessage());
    }
  }
}
