package org.palpate.imagej.stack;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import ij.ImagePlus;
import ij.ImageStack;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

class PixelSnapshotTest {
  private static final long SEED = Long.getLong("palpate.seed", 20261128);

  @ParameterizedTest
  @ValueSource(ints = {8, 16, 32})
  void reportsEachChangedPixelOnceWithItsNewValue(int bits) throws TouchRefusedException {
    SplittableRandom random = new SplittableRandom(SEED);
    int most = bits == 8 ? 255 : 40_000;
    ImagePlus image = Stacks.of(bits, 5, 4, 3, (i, j, k) -> random.nextInt(most));
    StackVolume volume = StackVolume.shownIn(image);
    PixelSnapshot snapshot = new PixelSnapshot(volume);
    assertEquals(Map.of(), changes(snapshot));
    for (int round = 0; round < 20; round++) {
      Map<String, Float> expected = new TreeMap<>();
      for (int n = random.nextInt(8); n > 0; n--) {
        int i = random.nextInt(5);
        int j = random.nextInt(4);
        int k = random.nextInt(3);
        float fresh = random.nextInt(most) + (bits == 32 ? 0.25f : 0);
        boolean changes = fresh != volume.slice(k).getf(i, j);
        volume.slice(k).setf(i, j, fresh);
        if (changes || expected.containsKey((j * 5 + i) + "@" + k)) {
          expected.put((j * 5 + i) + "@" + k, fresh);
        }
      }
      assertEquals(expected, changes(snapshot), "seed=" + SEED + " round=" + round);
      assertEquals(Map.of(), changes(snapshot));
    }
  }

  private static Map<String, Float> changes(PixelSnapshot snapshot) throws TouchRefusedException {
    Map<String, Float> found = new TreeMap<>();
    snapshot.changes(
        (n, k, value) -> assertEquals(null, found.put(n + "@" + k, value), "reported twice"));
    return found;
  }

  @ParameterizedTest
  @ValueSource(ints = {8, 16, 32})
  void keepsTheValuesOfTheCopy(int bits) throws TouchRefusedException {
    ImagePlus image = Stacks.of(bits, 3, 3, 3, (i, j, k) -> i + 10 * j + 80 * k);
    StackVolume volume = StackVolume.shownIn(image);
    PixelSnapshot snapshot = new PixelSnapshot(volume);
    ScalarVolume values = snapshot.values(VoxelGrid.ofUnitVoxels(3, 3, 3));
    volume.slice(1).setf(2, 1, 0);
    assertEquals(92, values.value(2, 1, 1));
    assertEquals(92, StackVolume.value(snapshot.slice(1), 5));
  }

  @ParameterizedTest
  @ValueSource(ints = {8, 16, 32})
  void refusesAStackOfAnotherSizeOrType(int bits) throws TouchRefusedException {
    ImagePlus image = Stacks.of(bits, 3, 3, 3, (i, j, k) -> 1);
    PixelSnapshot snapshot = new PixelSnapshot(StackVolume.shownIn(image));
    ImageStack other = Stacks.of(bits, 3, 4, 3, (i, j, k) -> 1).getStack();
    image.setStack(other);
    assertEquals(
        "The size or type of the stack changed while it was touched: start again.",
        assertThrows(TouchRefusedException.class, () -> changes(snapshot)).getMessage());
  }
}
