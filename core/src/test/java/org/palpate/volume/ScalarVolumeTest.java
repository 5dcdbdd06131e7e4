package org.palpate.volume;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.palpate.volume.ScalarVolume.Storage;

class ScalarVolumeTest {
  private final VoxelGrid grid = VoxelGrid.ofUnitVoxels(5, 4, 3);

  @Test
  void choosesTheNarrowestStorageForTheRange() {
    assertEquals(Storage.UINT8, Storage.forIntegers(0, 255));
    assertEquals(Storage.INT16, Storage.forIntegers(-1024, 3071));
    assertEquals(Storage.UINT16, Storage.forIntegers(0, 65535));
    assertEquals(Storage.FLOAT32, Storage.forIntegers(-1, 65535));
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
  void keepsTheEndsOfTheRangeAndClampsBeyondThem() {
    ScalarVolume signed = ScalarVolume.of(grid, Storage.INT16);
    signed.set(0, 0, 0, -40000);
    assertEquals(-32768, signed.value(0, 0, 0));
    ScalarVolume unsigned = ScalarVolume.of(grid, Storage.UINT16);
    unsigned.set(4, 3, 2, 65535);
    assertEquals(65535, unsigned.value(4, 3, 2));
  }

  @Test
  void readsTheArraysOfAnotherProgram() {
    short[][] shorts = new short[3][20];
    shorts[1][7] = -1;
    assertEquals(65535, ScalarVolume.over(grid, shorts).value(2, 1, 1));
    byte[][] bytes = new byte[3][20];
    bytes[2][19] = -1;
    assertEquals(255, ScalarVolume.over(grid, bytes).value(4, 3, 2));
    float[][] floats = new float[3][20];
    floats[0][5] = -2.5f;
    assertEquals(-2.5, ScalarVolume.over(grid, floats).value(0, 1, 0));
  }

  @Test
  void refusesSlicesOfAnotherSizeOrOfSeveralTypes() {
    Object[] mixed = {new byte[20], new byte[20], new short[20]};
    Object[] small = {new byte[20], new byte[19], new byte[20]};
    assertThrows(IllegalArgumentException.class, () -> ScalarVolume.over(grid, mixed));
    assertThrows(IllegalArgumentException.class, () -> ScalarVolume.over(grid, small));
    assertThrows(IllegalArgumentException.class, () -> ScalarVolume.over(grid, new byte[2][20]));
  }
}
