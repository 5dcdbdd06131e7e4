package org.palpate.io.volume;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.volume.VoxelGrid;

class AxisSignsTest {
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "LPS|RAS|(-1.0, -1.0, 1.0)",
        "RAS|LPS|(-1.0, -1.0, 1.0)",
        "LPS|LAS|(1.0, -1.0, 1.0)",
        "RAS|LAS|(-1.0, 1.0, 1.0)",
        "LAS|LAS|(1.0, 1.0, 1.0)",
        "UNKNOWN|UNKNOWN|(1.0, 1.0, 1.0)"
      })
  void eachCoordinateKeepsOrChangesItsSign(
      CoordinateSystem from, CoordinateSystem to, String signs) {
    assertEquals(signs, AxisSigns.between(from, to).orElseThrow().toString());
  }

  @Test
  void anUnknownWorldIsNotConverted() {
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(2, 3, 4);
    assertTrue(AxisSigns.between(CoordinateSystem.UNKNOWN, CoordinateSystem.RAS).isEmpty());
    assertTrue(AxisSigns.between(CoordinateSystem.LPS, CoordinateSystem.UNKNOWN).isEmpty());
    assertTrue(AxisSigns.convert(grid, CoordinateSystem.LPS, CoordinateSystem.UNKNOWN).isEmpty());
  }

  @Test
  void aConvertedGridHoldsTheSameVoxelsAtTheSamePlacesOfThePatient() {
    VoxelGrid grid =
        new VoxelGrid(
            5,
            6,
            7,
            new Vec3(0.5, 1, 2),
            new RigidTransform(
                new Vec3(0, 0.6, 0.8),
                new Vec3(-1, 0, 0),
                new Vec3(0, -0.8, 0.6),
                new Vec3(3, 4, 5)));
    VoxelGrid other =
        AxisSigns.convert(grid, CoordinateSystem.LPS, CoordinateSystem.RAS).orElseThrow();
    assertEquals(5, other.sizeX());
    assertEquals(7, other.sizeZ());
    Vec3 at = new Vec3(1.5, 2.5, 3.5);
    Vec3 lps = grid.gridToWorld(at, new Vec3());
    Vec3 ras = other.gridToWorld(at, new Vec3());
    assertEquals(-lps.x, ras.x, 1e-12);
    assertEquals(-lps.y, ras.y, 1e-12);
    assertEquals(lps.z, ras.z, 1e-12);
  }
}
