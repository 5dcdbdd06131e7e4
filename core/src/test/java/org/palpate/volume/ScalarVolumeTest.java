package org.palpate.volume;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.palpate.volume.ScalarVolume.Storage;

class ScalarVolumeTest {
  private final VoxelGrid grid = VoxelGrid.ofUnitVoxels(5, 4, 3);

  @Test
  void takesTheNarrowestStorageThatHoldsTheRange() {
    assertEquals(Storage.UINT8, Storage.forWholeNumbers(0, 255));
    assertEquals(Storage.INT16, Storage.forWholeNumbers(-1024, 3071));
    assertEquals(Storage.UINT16, Storage.forWholeNumbers(0, 65535));
    assertEquals(Storage.FLOAT32, Storage.forWholeNumbers(-1, 65535));
  }

  @Test
  void everyVoxelKeepsItsOwnValueInEveryStorage() {
    for (Storage storage : Storage.values()) {
      ScalarVolume volume = ScalarVolume.of(grid, storage);
      for (int n = 0; n < 60; n++) {
        volume.set(n % 5, n / 5 % 4, n / 20, n + 1);
      }
      for (int n = 0; n < 60; n++) {
        assertEquals(n + 1, volume.value(n % 5, n / 5 % 4, n / 20), storage.name());
      }
    }
  }

  @Test
  void keepsTheEndsOfTheRangeAndHoldsWhatLiesBeyond() {
    ScalarVolume signed = ScalarVolume.of(grid, Storage.INT16);
    signed.set(0, 0, 0, -40000);
    assertEquals(-32768, signed.value(0, 0, 0));
    ScalarVolume unsigned = ScalarVolume.of(grid, Storage.UINT16);
    unsigned.set(4, 3, 2, 65535);
    assertEquals(65535, unsigned.value(4, 3, 2));
  }
}
