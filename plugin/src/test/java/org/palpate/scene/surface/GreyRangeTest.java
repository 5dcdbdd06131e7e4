package org.palpate.scene.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

class GreyRangeTest {
  private static final double NONE = Double.POSITIVE_INFINITY;

  private static EdgeCrossings of(
      ScalarVolume.Storage storage, double low, double high, int... row) {
    ScalarVolume volume = ScalarVolume.of(VoxelGrid.ofUnitVoxels(row.length, 1, 1), storage);
    for (int i = 0; i < row.length; i++) {
      volume.set(i, 0, 0, row[i]);
    }
    return new GreyRange(volume, low, high).crossings();
  }

  @Test
  void aMaskHasCrossingsAtTheMidpoint() {
    EdgeCrossings mask = of(ScalarVolume.Storage.UINT8, 1, NONE, 0, 1, 0);
    assertEquals(0.5, mask.fraction(0, 0, 0, 0));
    assertEquals(0.5, mask.fraction(1, 0, 0, 0));
  }

  @Test
  void theSurfaceIsWhereTheValuesCrossTheThreshold() {
    EdgeCrossings bone = of(ScalarVolume.Storage.FLOAT32, 100, NONE, 0, 400);
    assertEquals(0.25, bone.fraction(0, 0, 0, 0), 1e-6);
  }

  @Test
  void aRangeHasCrossingsAtBothEnds() {
    EdgeCrossings soft = of(ScalarVolume.Storage.FLOAT32, 100, 200, 0, 150, 350);
    assertEquals(100.0 / 150, soft.fraction(0, 0, 0, 0), 1e-6);
    assertEquals(0.25, soft.fraction(1, 0, 0, 0), 1e-6);
  }

  @Test
  void theBorderAndEditedVoxelsHaveCrossingsAtTheMidpoint() {
    EdgeCrossings bone = of(ScalarVolume.Storage.FLOAT32, 100, NONE, 300, 400);
    assertEquals(0.5, bone.fraction(1, 0, 0, 0), "beyond the grid");
    assertEquals(0.5, bone.fraction(0, 0, 0, 0), "one of two solid voxels was emptied");
  }
}
