package org.palpate.volume;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.geometry.IntBox;
import org.palpate.testing.Seeds;

class BitCubeTest {
  private static final int EDITS = 4000;

  @ParameterizedTest
  @CsvSource({"1,1,1", "4,4,4", "5,1,9", "17,16,15", "33,2,70", "64,64,3"})
  void agreesWithABitSetUnderRandomEdits(int sizeX, int sizeY, int sizeZ) {
    BitCube cube = new BitCube(sizeX, sizeY, sizeZ);
    BitSet expected = new BitSet();
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    for (int n = 0; n < EDITS; n++) {
      int i = random.nextInt(sizeX);
      int j = random.nextInt(sizeY);
      int k = random.nextInt(sizeZ);
      boolean solid = random.nextInt(3) > 0;
      put(cube, i, j, k, solid);
      expected.set((k * sizeY + j) * sizeX + i, solid);
    }
    assertAgree(cube, expected);
    assertAgree(cube.copy(), expected);
    assertUpperLevelMarksFilledBricks(cube);
  }

  @Test
  void aCopyIsIndependentOfTheOriginal() {
    BitCube cube = new BitCube(9, 9, 9);
    cube.set(3, 4, 5);
    BitCube copy = cube.copy();
    cube.clear(3, 4, 5);
    copy.set(0, 0, 0);
    assertTrue(copy.get(3, 4, 5));
    assertFalse(cube.get(0, 0, 0));
    assertEquals(1, copy.block(0, 0, 0) & 1);
    assertEquals(0, cube.block(0, 0, 0));
  }

  @Test
  void isEmptyOutside() {
    BitCube cube = full(5, 6, 7);
    int[] ends = {-1, Integer.MIN_VALUE, Integer.MAX_VALUE};
    for (int end : ends) {
      assertFalse(cube.get(end, 0, 0));
      assertFalse(cube.get(0, end, 0));
      assertFalse(cube.get(0, 0, end));
      assertEquals(0, cube.brick(end, 0, 0));
      assertEquals(0, cube.block(0, 0, end >> 4));
    }
    assertFalse(cube.get(5, 0, 0));
    assertFalse(cube.get(0, 6, 0));
    assertFalse(cube.get(0, 0, 7));
  }

  @Test
  void refusesEditsOutside() {
    BitCube cube = new BitCube(5, 6, 7);
    assertThrows(IndexOutOfBoundsException.class, () -> cube.set(5, 0, 0));
    assertThrows(IndexOutOfBoundsException.class, () -> cube.set(0, -1, 0));
    assertThrows(IndexOutOfBoundsException.class, () -> cube.clear(0, 0, 7));
  }

  @Test
  void keepsPaddingBitsClear() {
    BitCube cube = full(5, 6, 7);
    long bits = 0;
    for (int z = 0; z < cube.bricksZ(); z++) {
      for (int y = 0; y < cube.bricksY(); y++) {
        for (int x = 0; x < cube.bricksX(); x++) {
          bits += Long.bitCount(cube.brick(x, y, z));
        }
      }
    }
    assertEquals(5 * 6 * 7, bits);
    assertThrows(IllegalArgumentException.class, () -> cube.setBrick(1, 0, 0, -1L));
    assertThrows(IllegalArgumentException.class, () -> cube.setBrick(2, 0, 0, 0));
  }

  @Test
  void replacesWholeBricks() {
    BitCube cube = new BitCube(8, 8, 8);
    cube.setBrick(1, 0, 1, 1L << BitCube.bit(6, 1, 5) | 1L << BitCube.bit(4, 3, 7));
    assertEquals(2, cube.solidCount());
    assertTrue(cube.get(6, 1, 5) && cube.get(4, 3, 7));
    assertEquals("x 4-6, y 1-3, z 5-7", cube.bounds().toString());
    cube.setBrick(1, 0, 1, 0);
    assertEquals(0, cube.solidCount());
    assertUpperLevelMarksFilledBricks(cube);
  }

  @Test
  void boundsOfBricksAreThoseOfTheirVoxels() {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    for (int run = 0; run < 2_000; run++) {
      BitCube byBrick = new BitCube(16, 16, 16);
      BitCube byVoxel = new BitCube(16, 16, 16);
      for (int brick = 0; brick < 3; brick++) {
        int x = random.nextInt(4);
        int y = random.nextInt(4);
        int z = random.nextInt(4);
        long word = 0;
        for (int voxel = random.nextInt(4); voxel >= 0; voxel--) {
          word |= 1L << random.nextInt(64);
        }
        byBrick.setBrick(x, y, z, word | byBrick.brick(x, y, z));
        for (long rest = word; rest != 0; rest &= rest - 1) {
          int bit = Long.numberOfTrailingZeros(rest);
          byVoxel.set(4 * x + (bit & 3), 4 * y + (bit >> 2 & 3), 4 * z + (bit >> 4));
        }
        assertEquals(
            byVoxel.bounds().toString(),
            byBrick.bounds().toString(),
            "seed=" + Seeds.seed() + " run=" + run);
      }
    }
  }

  @Test
  void boundsContainAllSolidsAndAreTightAfterTightening() {
    BitCube cube = new BitCube(40, 30, 20);
    cube.set(3, 4, 5);
    cube.set(30, 20, 10);
    assertEquals("x 3-30, y 4-20, z 5-10", cube.bounds().toString());
    cube.clear(30, 20, 10);
    assertTrue(cube.bounds().contains(3, 4, 5));
    cube.tightenBounds();
    assertEquals("x 3-3, y 4-4, z 5-5", cube.bounds().toString());
    cube.clear(3, 4, 5);
    cube.tightenBounds();
    assertTrue(cube.bounds().isEmpty());
    assertEquals("empty", new IntBox().toString());
  }

  @Test
  void reportsItsMemoryBeforeItIsCreated() {
    assertEquals(8.0 * (64 * 64 * 64 + 16 * 16 * 16), BitCube.bytesFor(256, 256, 256));
    assertTrue(BitCube.bytesFor(100_000, 100_000, 100_000) > 1e14);
    assertThrows(IllegalArgumentException.class, () -> new BitCube(100_000, 100_000, 100_000));
    assertThrows(IllegalArgumentException.class, () -> new BitCube(0, 1, 1));
  }

  @ParameterizedTest
  @CsvSource({"1,1,1", "5,1,9", "9,10,11"})
  void aWindowContainsTheVoxelsThatItCovers(int sizeX, int sizeY, int sizeZ) {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    BitCube cube = new BitCube(sizeX, sizeY, sizeZ);
    for (int n = 0; n < sizeX * sizeY * sizeZ; n++) {
      cube.set(random.nextInt(sizeX), random.nextInt(sizeY), random.nextInt(sizeZ));
    }
    for (int k = -5; k <= sizeZ; k++) {
      for (int j = -5; j <= sizeY; j++) {
        for (int i = -5; i <= sizeX; i++) {
          assertEquals(naiveWindow(cube, i, j, k), cube.window(i, j, k), "seed " + Seeds.seed());
        }
      }
    }
    assertEquals(0, cube.window(Integer.MIN_VALUE, Integer.MAX_VALUE, Integer.MAX_VALUE));
  }

  private static long naiveWindow(BitCube cube, int i, int j, int k) {
    long word = 0;
    for (int bit = 0; bit < 64; bit++) {
      if (cube.get(i + (bit & 3), j + (bit >> 2 & 3), k + (bit >> 4))) {
        word |= 1L << bit;
      }
    }
    return word;
  }

  private static void put(BitCube cube, int i, int j, int k, boolean solid) {
    if (solid) {
      cube.set(i, j, k);
    } else {
      cube.clear(i, j, k);
    }
  }

  private static BitCube full(int sizeX, int sizeY, int sizeZ) {
    BitCube cube = new BitCube(sizeX, sizeY, sizeZ);
    for (int k = 0; k < sizeZ; k++) {
      for (int j = 0; j < sizeY; j++) {
        for (int i = 0; i < sizeX; i++) {
          cube.set(i, j, k);
        }
      }
    }
    return cube;
  }

  private static void assertAgree(BitCube cube, BitSet expected) {
    assertEquals(expected.cardinality(), cube.solidCount(), "seed " + Seeds.seed());
    for (int k = 0; k < cube.sizeZ(); k++) {
      for (int j = 0; j < cube.sizeY(); j++) {
        for (int i = 0; i < cube.sizeX(); i++) {
          boolean solid = expected.get((k * cube.sizeY() + j) * cube.sizeX() + i);
          assertEquals(solid, cube.get(i, j, k), "seed " + Seeds.seed());
          assertTrue(!solid || cube.bounds().contains(i, j, k));
        }
      }
    }
  }

  private static void assertUpperLevelMarksFilledBricks(BitCube cube) {
    for (int z = 0; z < cube.bricksZ(); z++) {
      for (int y = 0; y < cube.bricksY(); y++) {
        for (int x = 0; x < cube.bricksX(); x++) {
          boolean marked = (cube.block(x >> 2, y >> 2, z >> 2) >>> BitCube.bit(x, y, z) & 1) != 0;
          assertEquals(cube.brick(x, y, z) != 0, marked);
        }
      }
    }
  }
}
