package org.palpate.volume;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class InterpolatedValuesTest {
  private static ScalarVolume linear() {
    ScalarVolume volume =
        ScalarVolume.of(VoxelGrid.ofUnitVoxels(5, 4, 3), ScalarVolume.Storage.FLOAT32);
    for (int k = 0; k < 3; k++) {
      for (int j = 0; j < 4; j++) {
        for (int i = 0; i < 5; i++) {
          volume.set(i, j, k, 3 * i - 10 * j + 100 * k);
        }
      }
    }
    return volume;
  }

  @Test
  void aLinearFunctionIsReproducedBetweenTheMiddlesOfVoxels() {
    ScalarVolume volume = linear();
    for (double x = 0.5; x <= 4.5; x += 0.25) {
      for (double y = 0.5; y <= 3.5; y += 0.3) {
        for (double z = 0.5; z <= 2.5; z += 0.4) {
          double expected = 3 * (x - 0.5) - 10 * (y - 0.5) + 100 * (z - 0.5);
          assertEquals(expected, volume.interpolated(x, y, z), 1e-9);
        }
      }
    }
  }

  @Test
  void outsideTheGridItsNearestPositionCounts() {
    ScalarVolume volume = linear();
    assertEquals(volume.value(0, 0, 0), volume.interpolated(-7, 0.1, 0));
    assertEquals(volume.value(4, 3, 2), volume.interpolated(1e300, 9, 3));
  }
}
