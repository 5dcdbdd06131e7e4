package org.palpate.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

/** Compares empty cubes with a search of all voxels. */
class EmptyCubeTest {
  private static final int SIZE = 30;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @Test
  void isTheLargestDoubledCubeThatNoClosedVoxelTouches() {
    TreeSet<Double> seen = new TreeSet<>();
    for (int round = 0; round < 20; round++) {
      BitCube bits = voxels(round % 4 == 0 ? 2 : 20);
      List<int[]> solids = solids(bits);
      for (int n = 0; n < 2_000; n++) {
        double x = coordinate();
        double y = coordinate();
        double z = coordinate();
        double found = EmptyCube.around(bits, x, y, z);
        assertEquals(naive(solids, x, y, z), found, x + " " + y + " " + z);
        seen.add(found);
      }
    }
    assertEquals(6, seen.size(), seen.toString());
  }

  @Test
  void thereIsNoneAroundWhatIsNoPoint() {
    BitCube bits = new BitCube(4, 4, 4);
    for (double far : new double[] {Double.NaN, Double.POSITIVE_INFINITY, -0x1p29, 1e300}) {
      assertEquals(0, EmptyCube.around(bits, 1, far, 1));
    }
    assertTrue(EmptyCube.around(bits, 1, -1e8, 1) > 0);
  }

  private BitCube voxels(int count) {
    BitCube bits = new BitCube(SIZE, SIZE - 1, SIZE - 3);
    for (int n = 0; n < count; n++) {
      bits.set(random.nextInt(SIZE), random.nextInt(SIZE - 1), random.nextInt(SIZE - 3));
    }
    return bits;
  }

  /** Returns a coordinate that often lies on a quarter of a voxel, or beside it by rounding. */
  private double coordinate() {
    double value = random.nextDouble(-6, SIZE + 6);
    double quarter = Math.rint(4 * value) / 4;
    return switch (random.nextInt(4)) {
      case 0 -> quarter;
      case 1 -> Math.nextUp(quarter);
      case 2 -> Math.nextDown(quarter);
      default -> value;
    };
  }

  private static List<int[]> solids(BitCube bits) {
    List<int[]> solids = new ArrayList<>();
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          if (bits.get(i, j, k)) {
            solids.add(new int[] {i, j, k});
          }
        }
      }
    }
    return solids;
  }

  private static double naive(List<int[]> solids, double x, double y, double z) {
    double found = 0;
    for (double half = 0.25; half <= 4; half *= 2) {
      for (int[] voxel : solids) {
        if (meets(voxel[0], x, half) && meets(voxel[1], y, half) && meets(voxel[2], z, half)) {
          return found;
        }
      }
      found = half;
    }
    return found;
  }

  private static boolean meets(int cell, double centre, double half) {
    return centre - half <= cell + 1 && centre + half >= cell;
  }
}
