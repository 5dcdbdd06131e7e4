package org.palpate.body;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.IntBox;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class BrickClearanceTest {
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @Test
  void isNeverMoreThanTheTrueDistanceAndNeverFarBelow() {
    for (int round = 0; round < 20; round++) {
      BitCube bits = dust(1 + random.nextInt(6));
      BrickClearance clearance = new BrickClearance(bits);
      for (int n = 0; n < 500; n++) {
        assertBounds(bits, clearance, coordinate(50), coordinate(37), coordinate(30));
      }
    }
  }

  @Test
  void staysALowerBoundAndSharpAfterVoxelsWereAdded() {
    BitCube bits = dust(1);
    BrickClearance clearance = new BrickClearance(bits);
    for (int round = 0; round < 30; round++) {
      int i = random.nextInt(50);
      int j = random.nextInt(37);
      int k = random.nextInt(30);
      bits.set(i, j, k);
      IntBox box = new IntBox();
      box.include(i, j, k);
      clearance.solidsAdded(box);
      BrickClearance fresh = new BrickClearance(bits);
      for (int n = 0; n < 200; n++) {
        double x = coordinate(50);
        double y = coordinate(37);
        double z = coordinate(30);
        assertEquals(fresh.at(x, y, z), clearance.at(x, y, z));
      }
    }
  }

  private void assertBounds(BitCube bits, BrickClearance clearance, double x, double y, double z) {
    double exact = Double.POSITIVE_INFINITY;
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          if (bits.get(i, j, k)) {
            exact = Math.min(exact, chebyshev(x - i, y - j, z - k));
          }
        }
      }
    }
    double bound = clearance.at(x, y, z);
    assertTrue(bound <= exact, bound + " exceeds " + exact);
    double limit = 4.0 * (BrickClearance.LARGEST_BRICKS - 1);
    boolean inside = x >= 0 && x <= 50 && y >= 0 && y <= 37 && z >= 0 && z <= 30;
    assertTrue(!inside || bound >= Math.min(limit, exact) - 8, bound + " is far below " + exact);
  }

  /** The distance from the closed voxel [0,1]^3. */
  private static double chebyshev(double x, double y, double z) {
    return Math.max(beyond(x), Math.max(beyond(y), beyond(z)));
  }

  private static double beyond(double v) {
    return Math.max(0, Math.max(-v, v - 1));
  }

  private double coordinate(int size) {
    return random.nextInt(4) == 0 ? random.nextInt(-3, size + 3) : random.nextDouble(-9, size + 9);
  }

  private BitCube dust(int voxels) {
    BitCube bits = new BitCube(50, 37, 30);
    for (int n = 0; n < voxels; n++) {
      bits.set(random.nextInt(50), random.nextInt(37), random.nextInt(30));
    }
    return bits;
  }
}
