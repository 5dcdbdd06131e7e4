package org.palpate.body;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.testing.RandomGeometry;
import org.palpate.volume.BitCube;

/** Compares heights of solids with those of every corner of every voxel. */
class SolidHeightsTest {
  private static final int EDGE = 30;
  private static final double ROUNDING = 1e-12 * EDGE;

  private final SplittableRandom random = new SplittableRandom(18);
  private final BitCube bits = new BitCube(EDGE, EDGE - 3, EDGE + 5);
  private final SolidHeights heights = new SolidHeights(bits);
  private final Vec3 direction = new Vec3(1, 0, 0);
  private final Vec3 low = new Vec3();
  private final Vec3 high = new Vec3();

  @Test
  void heightsAreThoseOfTheHighestVoxelOfTheBricksAfterEditsToo() {
    int found = 0;
    int empty = 0;
    int tooLarge = 0;
    for (int edit = 0; edit < 300; edit++) {
      edit(edit);
      for (int n = 0; n < 40; n++) {
        randomBox();
        double most = heights.most(low.x, low.y, low.z, high.x, high.y, high.z);
        if (bricks() > SolidHeights.MOST_BRICKS) {
          assertEquals(Double.POSITIVE_INFINITY, most);
          tooLarge++;
        } else {
          double expected = mostByVoxels();
          if (expected == Double.NEGATIVE_INFINITY) {
            assertEquals(expected, most);
            empty++;
          } else {
            assertEquals(expected, most, ROUNDING);
            found++;
          }
        }
      }
    }
    assertTrue(found > 3_000 && empty > 500, found + " found, " + empty + " empty");
    assertTrue(tooLarge > 500, tooLarge + " too large");
  }

  private void edit(int edit) {
    for (int n = 0; n < 3; n++) {
      bits.set(random.nextInt(EDGE), random.nextInt(EDGE - 3), random.nextInt(EDGE + 5));
    }
    if (edit % 3 == 0) {
      bits.clear(random.nextInt(EDGE), random.nextInt(EDGE - 3), random.nextInt(EDGE + 5));
    }
    if (edit % 40 == 39) {
      fillBrick(random.nextInt(EDGE / 4 - 1));
    }
    if (edit % 5 == 0) {
      direction.set(RandomGeometry.vector(random, 1));
      direction.set(random.nextInt(3), random.nextInt(-1, 2));
      heights.setDirection(direction.x, direction.y, direction.z);
    } else {
      heights.forget();
    }
  }

  private void fillBrick(int brick) {
    for (int n = 0; n < 64; n++) {
      bits.set(4 * brick + (n & 3), 4 * brick + (n >> 2 & 3), 4 * brick + (n >> 4));
    }
  }

  /** Sets a box; some faces lie on those of voxels, and some boxes outside the cube. */
  private void randomBox() {
    double longest = random.nextInt(6) == 0 ? 40 : 9;
    for (int axis = 0; axis < 3; axis++) {
      double first = random.nextDouble(-6, longest > 9 ? 8 : EDGE + 8);
      first = random.nextInt(3) == 0 ? Math.rint(first) : first;
      low.set(axis, first);
      double last = first + random.nextDouble(longest);
      high.set(axis, random.nextInt(3) == 0 ? Math.rint(last) : last);
      if (high.get(axis) < first) {
        high.set(axis, first);
      }
    }
  }

  /** Whether the closed voxel of a number touches the box along an axis. */
  private boolean touches(int voxel, int axis) {
    return voxel + 1 >= low.get(axis) && voxel <= high.get(axis);
  }

  private boolean brickTouches(int brick, int axis) {
    boolean any = false;
    for (int voxel = 4 * brick; voxel < 4 * brick + 4; voxel++) {
      any |= touches(voxel, axis);
    }
    return any;
  }

  private int bricks() {
    return bricks(0, bits.bricksX()) * bricks(1, bits.bricksY()) * bricks(2, bits.bricksZ());
  }

  private int bricks(int axis, int count) {
    int sum = 0;
    for (int brick = 0; brick < count; brick++) {
      sum += brickTouches(brick, axis) ? 1 : 0;
    }
    return sum;
  }

  private double mostByVoxels() {
    double most = Double.NEGATIVE_INFINITY;
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          if (bits.get(i, j, k)
              && brickTouches(i >> 2, 0)
              && brickTouches(j >> 2, 1)
              && brickTouches(k >> 2, 2)) {
            most = Math.max(most, highestCorner(i, j, k));
          }
        }
      }
    }
    return most;
  }

  private double highestCorner(int i, int j, int k) {
    double most = Double.NEGATIVE_INFINITY;
    for (int corner = 0; corner < 8; corner++) {
      Vec3 at = new Vec3(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2));
      most = Math.max(most, at.dot(direction));
    }
    return most;
  }
}
