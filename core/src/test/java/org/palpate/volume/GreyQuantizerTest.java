package org.palpate.volume;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.palpate.testing.Seeds;
import org.palpate.volume.ScalarVolume.Storage;

class GreyQuantizerTest {
  private final long seed = Seeds.seed();
  private final Random random = new Random(seed);

  @Test
  void aLevelIsAtLeast128ExactlyFromTheMiddleOn() {
    double middle = 0;
    GreyQuantizer levels = new GreyQuantizer(middle, 1);
    for (int n = 0; n < 200_000; n++) {
      if (n % 20 == 0) {
        middle = anyMiddle();
        levels = anyLevels(middle);
      }
      double value = n % 3 == 0 ? near(middle) : anyMiddle();
      int level = levels.of(value);
      assertEquals(value >= middle, level >= 128, "seed=" + seed + " " + middle + " " + value);
      assertEquals(true, level >= 0 && level <= 255);
    }
  }

  @Test
  void aLevelIsProportionalToTheDistanceFromTheMiddle() {
    GreyQuantizer levels = new GreyQuantizer(100, 127.5 / 40);
    assertEquals(128, levels.of(100));
    assertEquals(0, levels.of(59));
    assertEquals(255, levels.of(140));
    assertEquals(191, levels.of(120));
    assertEquals(64, levels.of(80));
    assertEquals(0, levels.of(Double.NaN));
    assertEquals(255, levels.of(Double.POSITIVE_INFINITY));
    assertEquals(0, levels.of(Double.NEGATIVE_INFINITY));
  }

  @Test
  void integersAndFractionsHaveTheSameScale() {
    for (int n = 0; n < 100_000; n++) {
      double middle = 2000 * random.nextDouble() - 500;
      double contrast = 1 + 300 * random.nextDouble();
      GreyQuantizer levels = new GreyQuantizer(middle, 127.5 / contrast);
      int value = random.nextInt(2500) - 700;
      double exact = 128 + 127.5 * (value - middle) / contrast;
      double clamped = Math.max(0, Math.min(255, exact));
      assertEquals(
          clamped, levels.of(value) + 0.5, 0.6, "seed=" + seed + " " + middle + " " + value);
      assertEquals(levels.of(value), levels.of(value + 1e-7), 1, "seed=" + seed);
    }
  }

  @Test
  void eightLevelsAtOnceEqualThoseOneByOne() {
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(19, 3, 2);
    GreyQuantizer levels = new GreyQuantizer(90.25, 1.7);
    for (Storage storage : Storage.values()) {
      ScalarVolume volume = ScalarVolume.of(grid, storage);
      for (int n = 0; n < 19 * 6; n++) {
        volume.set(n % 19, n / 19 % 3, n / 57, 400 * random.nextDouble() - 100);
      }
      for (int from = 0; from <= 11; from++) {
        long eight = volume.levels(from, 1, 1, levels);
        for (int n = 0; n < 8; n++) {
          assertEquals(
              levels.of(volume.value(from + n, 1, 1)), eight >>> (8 * n) & 0xff, storage.name());
        }
      }
    }
  }

  @ParameterizedTest
  @EnumSource(names = {"UINT8", "INT16", "UINT16"})
  void everyStoredIntegerHasItsLevel(Storage storage) {
    int least = storage == Storage.INT16 ? Short.MIN_VALUE : 0;
    int count = storage == Storage.UINT8 ? 256 : 65536;
    ScalarVolume volume = ScalarVolume.of(VoxelGrid.ofUnitVoxels(count, 1, 1), storage);
    for (int n = 0; n < count; n++) {
      volume.set(n, 0, 0, least + n);
    }
    for (int cases = 0; cases < 20; cases++) {
      GreyQuantizer levels = anyLevels(anyMiddle());
      for (int from = 0; from < count; from += 8) {
        long eight = volume.levels(from, 0, 0, levels);
        for (int n = 0; n < 8; n++) {
          assertEquals(
              levels.of(least + from + n), eight >>> (8 * n) & 0xff, "seed=" + seed + " " + from);
        }
      }
    }
  }

  @Test
  void refusesASlopeThatIsNotPositive() {
    assertThrows(IllegalArgumentException.class, () -> new GreyQuantizer(0, 0));
    assertThrows(IllegalArgumentException.class, () -> new GreyQuantizer(0, Double.NaN));
  }

  private GreyQuantizer anyLevels(double middle) {
    return new GreyQuantizer(middle, 127.5 / Math.exp(20 * random.nextDouble() - 10));
  }

  private double anyMiddle() {
    double any = (random.nextDouble() - 0.5) * Math.pow(10, random.nextInt(8));
    return random.nextBoolean() ? Math.rint(any) : any;
  }

  private double near(double middle) {
    return switch (random.nextInt(4)) {
      case 0 -> middle;
      case 1 -> Math.nextDown(middle);
      case 2 -> Math.ceil(middle);
      default -> Math.floor(middle);
    };
  }
}
