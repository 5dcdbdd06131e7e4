package org.palpate.proxy.smooth;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;

/** Voxels are 1 x 0.5 x 2 mm: 2, 1 and 4 shortest edges. */
class EdgeUnitsTest {
  private final EdgeUnits units = new EdgeUnits(new GridMetric(1, 0.5, 2));
  private final Vec3 from = new Vec3(3, 4, 5);
  private final Vec3 to = new Vec3(4, 6, 8);
  private final Vec3 dest = new Vec3();

  @Test
  void theShortestEdgeIsOne() {
    assertEquals(0.5, units.shortestMm());
    assertEquals(2, units.x());
    assertEquals(1, units.y());
    assertEquals(4, units.z());
  }

  @Test
  void distancesAndVectorsAreInEdges() {
    units.vector(from, to, dest);
    assertTrue(dest.sameBits(new Vec3(2, 2, 12)));
    assertEquals(dest.length(), units.distance(from, to), 1e-15);
  }

  @Test
  void theHeightOverAPlaneIsInEdges() {
    assertEquals(2, units.height(to, from, new Vec3(1, 0, 0)));
    assertEquals(-2, units.height(to, from, new Vec3(0, -1, 0)));
    assertEquals(12, units.height(to, from, new Vec3(0, 0, 1)));
    assertEquals(0.6 * 2 + 0.8 * 12, units.height(to, from, new Vec3(0.6, 0, 0.8)), 1e-15);
  }

  @Test
  void anOffsetInEdgesMovesByFewerVoxelsAlongLongOnes() {
    units.offset(from, 8, new Vec3(1, 0, 0), dest);
    assertTrue(dest.sameBits(new Vec3(3 + 4, 4, 5)));
    units.offset(from, 8, new Vec3(0, 1, 0), dest);
    assertTrue(dest.sameBits(new Vec3(3, 4 + 8, 5)));
    units.offset(from, 8, new Vec3(0, 0, -1), dest);
    assertTrue(dest.sameBits(new Vec3(3, 4, 5 - 2)));
    assertEquals(8, units.distance(from, dest));
  }
}
