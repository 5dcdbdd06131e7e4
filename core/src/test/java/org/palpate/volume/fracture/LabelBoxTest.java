package org.palpate.volume.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.IntBox;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class LabelBoxTest {
  private static final BitCube SIZES = new BitCube(12, 10, 11);

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final IntBox box = new IntBox();
  private final int[][][] plain = new int[12][10][11];
  private final LabelBox labels;

  LabelBoxTest() {
    box.include(2, 1, 3);
    box.include(9, 8, 9);
    labels = new LabelBox(box);
  }

  private void set(int i, int j, int k, int label) {
    labels.set(i, j, k, label);
    plain[i][j][k] = label;
  }

  private void setAtRandom(int count, int most) {
    for (int n = 0; n < count; n++) {
      set(
          random.nextInt(2, 10),
          random.nextInt(1, 9),
          random.nextInt(3, 10),
          random.nextInt(most + 1));
    }
  }

  private int plain(int i, int j, int k) {
    return box.contains(i, j, k) ? plain[i][j][k] : 0;
  }

  @Test
  void holdsTheLabelsOfItsVoxelsAndNoneOutside() {
    setAtRandom(300, 127);
    LabelBox copy = labels.copy();
    set(5, 5, 5, plain(5, 5, 5) == 9 ? 10 : 9);
    for (int n = 0; n < 14 * 14 * 14; n++) {
      int i = n % 14 - 1;
      int j = n / 14 % 14 - 1;
      int k = n / 196 - 1;
      assertEquals(plain(i, j, k), labels.get(i, j, k));
      assertEquals(i == 5 && j == 5 && k == 5, copy.get(i, j, k) != labels.get(i, j, k));
    }
  }

  @Test
  void theVoxelsOfALabelLieInACubeOfTheGivenSizes() {
    setAtRandom(300, 3);
    BitCube two = labels.bits(2, SIZES);
    assertEquals(12, two.sizeX());
    assertEquals(11, two.sizeZ());
    for (int n = 0; n < 12 * 10 * 11; n++) {
      int i = n % 12;
      int j = n / 12 % 10;
      int k = n / 120;
      assertEquals(plain(i, j, k) == 2, two.get(i, j, k));
    }
  }

  @Test
  void theLargestComponentOfALabelStaysAndTheOthersBecomeStrays() {
    for (int n = 0; n < 8; n++) {
      set(3 + n % 2, 3 + n / 2 % 2, 4 + n / 4, 5);
    }
    set(5, 5, 6, 5); // touches the cube at a corner
    set(9, 8, 9, 5);
    set(9, 8, 8, 5);
    set(7, 1, 3, 5);
    set(7, 1, 4, 6);
    BitCube strays = new BitCube(12, 10, 11);
    labels.keepLargest(5, strays);
    assertEquals(9, labels.bits(5, SIZES).solidCount());
    assertEquals(3, strays.solidCount());
    assertTrue(strays.get(9, 8, 9) && strays.get(9, 8, 8) && strays.get(7, 1, 3));
    assertEquals(0, labels.get(9, 8, 9));
    assertEquals(0, labels.get(7, 1, 3));
    assertEquals(6, labels.get(7, 1, 4), "another label stays");
    assertEquals(5, labels.get(5, 5, 6));
  }

  @Test
  void neighboursAreCountedAmongTheTwentySevenAroundAVoxel() {
    setAtRandom(300, 4);
    for (int n = 0; n < 300; n++) {
      int i = random.nextInt(1, 11);
      int j = random.nextInt(10);
      int k = random.nextInt(2, 11);
      int[] expected = new int[5];
      for (int z = k - 1; z <= k + 1; z++) {
        for (int y = j - 1; y <= j + 1; y++) {
          for (int x = i - 1; x <= i + 1; x++) {
            expected[plain(x, y, z)]++;
          }
        }
      }
      int[] counts = {100, 0, 0, 0, 0};
      labels.countNeighbours(i, j, k, counts);
      assertEquals(100 + expected[0], counts[0]);
      for (int label = 1; label < 5; label++) {
        assertEquals(expected[label], counts[label]);
      }
    }
  }

  @Test
  void aNearLabelIsFoundWithinSomeStepsAlongEachAxis() {
    setAtRandom(40, 9);
    int found = 0;
    for (int n = 0; n < 500; n++) {
      int i = random.nextInt(2, 10);
      int j = random.nextInt(1, 9);
      int k = random.nextInt(3, 10);
      int steps = random.nextInt(4);
      boolean expected = false;
      for (int z = k - steps; z <= k + steps; z++) {
        for (int y = j - steps; y <= j + steps; y++) {
          for (int x = i - steps; x <= i + steps; x++) {
            expected |= plain(x, y, z) >= 4 && plain(x, y, z) <= 7;
          }
        }
      }
      assertEquals(expected, labels.hasNear(i, j, k, steps, 4, 7));
      found += expected ? 1 : 0;
    }
    assertTrue(found > 50 && found < 450, "found: " + found);
    assertFalse(new LabelBox(box).hasNear(5, 5, 5, 9, 1, 127));
  }
}
