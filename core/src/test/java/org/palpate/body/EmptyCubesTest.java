package org.palpate.body;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.volume.BitCube;

/** Compares remembered empty cubes with a search through all voxels. */
class EmptyCubesTest {
  private static final int EDGE = 40;

  private final SplittableRandom random = new SplittableRandom(18);
  private final BitCube bits = new BitCube(EDGE, EDGE - 3, EDGE + 5);
  private final EmptyCubes cubes = new EmptyCubes(bits);

  @Test
  void cubesAreEmptyAndTheLargestThatWindowsProveAfterEditsToo() {
    int[] seen = new int[EmptyCubes.LARGEST_HALF_EDGE + 1];
    for (int edit = 0; edit < 60; edit++) {
      bits.set(coordinate(0, 40), coordinate(0, 37), coordinate(0, 45));
      if (edit % 4 == 3) {
        bits.clear(coordinate(0, 40), coordinate(0, 37), coordinate(0, 45));
      }
      cubes.forget();
      for (int n = 0; n < 4_000; n++) {
        double x = random.nextDouble(-6, EDGE + 6);
        double y = random.nextDouble(-6, EDGE + 6);
        double z = n % 3 == 0 ? coordinate(-6, EDGE + 10) : random.nextDouble(-6, EDGE + 10);
        int half = emptyHalfEdge(corner(x), corner(y), corner(z));
        double off = Math.max(off(x), Math.max(off(y), off(z)));
        assertEquals(half == 0 ? 0 : half - off, cubes.around(x, y, z));
        seen[half]++;
      }
    }
    for (int count : seen) {
      assertTrue(count > 100, "too few of a size: " + count);
    }
  }

  @Test
  void aCubeWithManyBricksSharesPlacesAndStillAnswersRightly() {
    BitCube large = new BitCube(300, 280, 260);
    for (int n = 0; n < 60_000; n++) {
      large.set(random.nextInt(300), random.nextInt(280), random.nextInt(260));
    }
    EmptyCubes ofLarge = new EmptyCubes(large);
    for (int round = 0; round < 3; round++) {
      SplittableRandom same = new SplittableRandom(7);
      for (int n = 0; n < 60_000; n++) {
        int x = same.nextInt(300);
        int y = same.nextInt(280);
        int z = same.nextInt(260);
        assertEquals(EmptyCubes.halfEdge(large, x, y, z), ofLarge.around(x, y, z));
      }
    }
  }

  @Test
  void pointsWithoutAWindowHaveNoCube() {
    for (double far : new double[] {-0x1p330, -0x1p30, 0x1p30, 1e12, Double.NaN}) {
      assertEquals(0, cubes.around(far, 1, 1));
      assertEquals(0, cubes.around(1, far, 1));
      assertEquals(0, cubes.around(1, 1, far));
    }
  }

  private int coordinate(int from, int end) {
    return random.nextInt(from, end);
  }

  private static int corner(double v) {
    return (int) Math.floor(v + 0.5);
  }

  private static double off(double v) {
    return Math.abs(v - corner(v));
  }

  /** Returns the largest half edge, at most that which is found, of an empty cube. */
  private int emptyHalfEdge(int x, int y, int z) {
    for (int half = 1; half <= EmptyCubes.LARGEST_HALF_EDGE; half++) {
      for (int k = z - half; k < z + half; k++) {
        for (int j = y - half; j < y + half; j++) {
          for (int i = x - half; i < x + half; i++) {
            if (bits.get(i, j, k)) {
              return half - 1;
            }
          }
        }
      }
    }
    return EmptyCubes.LARGEST_HALF_EDGE;
  }
}
