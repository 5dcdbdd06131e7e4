package org.palpate.volume;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.palpate.testing.Seeds;
import org.palpate.volume.ScalarVolume.Storage;

class GreyQuantizerTest {
  private final long seed = Seeds.seed();
  private final Random random = new Random(seed);

  @Test
  void aLevelIsAtLeast128ExactlyFromTheMiddleOn() {
    for (int n = 0; n < 200_000; n++) {
      double middle = anyMiddle();
      GreyQuantizer levels =
          new GreyQuantizer(middle, 127.5 / Math.exp(20 * random.nextDouble() - 10));
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

  @Test
  void refusesASlopeThatIsNotPositive() {
    assertThrows(IllegalArgumentException.class, () -> new GreyQuantizer(0, 0));
    assertThrows(IllegalArgumentException.class, () -> new GreyQuantizer(0, Double.NaN));
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
