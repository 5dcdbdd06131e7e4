package org.palpate.force.guide;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** Distances from a segment, against a search of all voxels; voxels of three different edges. */
class SegmentDistanceTest {
  private static final Vec3 SPACING = new Vec3(1, 1.5, 0.8);
  private static final double REACH_MM = 4;
  private static final VoxelGrid GRID =
      new VoxelGrid(14, 12, 16, SPACING, RigidTransform.identity());

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final BitCube solids = new BitCube(14, 12, 16);
  private final SegmentDistance distances;

  SegmentDistanceTest() {
    for (int n = 0; n < 10; n++) {
      solids.set(random.nextInt(4, 9), random.nextInt(4, 8), random.nextInt(5, 10));
    }
    distances = new SegmentDistance(solids, GRID, REACH_MM);
  }

  /** Returns the distance of the middle of a voxel from the nearest solid one as a closed box. */
  private double distanceOfMiddle(int i, int j, int k) {
    double least = Double.POSITIVE_INFINITY;
    for (int n = 0; n < 14 * 12 * 16; n++) {
      int a = n % 14;
      int b = n / 14 % 12;
      int c = n / (14 * 12);
      if (solids.get(a, b, c)) {
        double x = Math.max(0, Math.abs(i - a) - 0.5) * SPACING.x;
        double y = Math.max(0, Math.abs(j - b) - 0.5) * SPACING.y;
        double z = Math.max(0, Math.abs(k - c) - 0.5) * SPACING.z;
        least = Math.min(least, Math.sqrt(x * x + y * y + z * z));
      }
    }
    return least;
  }

  @Test
  void theMiddleOfAVoxelHasItsExactDistanceWithinTheReach() {
    int near = 0;
    for (int n = 0; n < 20 * 20 * 20; n++) {
      int i = n % 20 - 3;
      int j = n / 20 % 20 - 4;
      int k = n / 400 - 2;
      double expected = distanceOfMiddle(i, j, k);
      double found = distances.at(i + 0.5, j + 0.5, k + 0.5);
      if (expected <= REACH_MM) {
        near++;
        assertEquals(expected, found, 1e-5, i + "," + j + "," + k);
      } else {
        assertTrue(found >= REACH_MM - 1e-5, i + "," + j + "," + k + ": " + found);
      }
    }
    assertTrue(near > 500, "near: " + near);
  }

  @Test
  void betweenMiddlesDistancesAreInterpolatedAlongEachAxis() {
    for (int n = 0; n < 2_000; n++) {
      int i = random.nextInt(4, 8);
      int j = random.nextInt(4, 7);
      int k = random.nextInt(5, 9);
      double[] part = {random.nextDouble(), random.nextDouble(), random.nextDouble()};
      double expected = 0;
      for (int corner = 0; corner < 8; corner++) {
        double weight = 1;
        for (int axis = 0; axis < 3; axis++) {
          weight *= (corner >> axis & 1) == 0 ? 1 - part[axis] : part[axis];
        }
        expected +=
            weight * distanceOfMiddle(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2));
      }
      double found = distances.at(i + 0.5 + part[0], j + 0.5 + part[1], k + 0.5 + part[2]);
      assertEquals(expected, found, 1e-5, "seed " + Seeds.seed());
    }
  }

  /** The direction is the difference over a voxel along each axis, cut to the length 1. */
  @Test
  void theGradientIsTheDifferenceOverAVoxelAndAtMostOneLong() {
    int cut = 0;
    int whole = 0;
    for (int n = 0; n < 3_000; n++) {
      Vec3 at = new Vec3(random.nextDouble(14), random.nextDouble(12), random.nextDouble(16));
      Vec3 found = new Vec3();
      distances.gradient(at, found);
      double[] expected = new double[3];
      double squared = 0;
      for (int axis = 0; axis < 3; axis++) {
        Vec3 ahead = new Vec3().set(at);
        Vec3 behind = new Vec3().set(at);
        ahead.set(axis, at.get(axis) + 0.5);
        behind.set(axis, at.get(axis) - 0.5);
        double rise =
            distances.at(ahead.x, ahead.y, ahead.z) - distances.at(behind.x, behind.y, behind.z);
        expected[axis] = rise / SPACING.get(axis);
        squared += expected[axis] * expected[axis];
      }
      double length = Math.sqrt(squared);
      cut += length > 1 ? 1 : 0;
      whole += length > 0.1 && length < 1 ? 1 : 0;
      for (int axis = 0; axis < 3; axis++) {
        assertEquals(expected[axis] / Math.max(1, length), found.get(axis), 1e-12);
      }
    }
    assertTrue(cut > 5 && whole > 100, "cut " + cut + ", whole " + whole);
  }

  @Test
  void theGradientLeadsAwayFromASingleVoxel() {
    BitCube one = new BitCube(14, 12, 16);
    one.set(6, 5, 7);
    SegmentDistance single = new SegmentDistance(one, GRID, REACH_MM);
    Vec3 gradient = new Vec3();
    single.gradient(new Vec3(8.5, 5.5, 7.5), gradient);
    assertEquals(1, gradient.x, 1e-6);
    single.gradient(new Vec3(6.5, 4, 7.5), gradient);
    assertTrue(gradient.y < -0.5 && Math.abs(gradient.x) < 1e-9, gradient.toString());
    single.gradient(new Vec3(6.5, 5.5, 10), gradient);
    assertEquals(1, gradient.z, 1e-5);
  }

  /** The box of the segment grows on each side by the reach and the longest edge, then by 2. */
  @Test
  void theNumberOfKeptVoxelsFollowsFromReachAndSpacing() {
    BitCube bits = new BitCube(14, 12, 16);
    bits.set(3, 4, 5);
    bits.set(5, 7, 9);
    assertEquals(
        (3 + 2 * 5) * (4 + 2 * 4) * (5 + 2 * 6),
        SegmentDistance.voxelsFor(bits, GRID, 1),
        "2.5 mm, which are 3, 2 and 4 voxels");
    for (double reach : new double[] {0.3, 1, 2.2, 4, 7.7}) {
      double found = SegmentDistance.voxelsFor(bits, GRID, reach);
      double expected =
          (3 + 2 * pad(reach, 1)) * (4 + 2 * pad(reach, 1.5)) * (5 + 2 * pad(reach, 0.8));
      assertEquals(expected, found, "reach " + reach);
    }
    assertEquals(0, SegmentDistance.voxelsFor(new BitCube(4, 4, 4), GRID, 5));
  }

  private static double pad(double reachMm, double edgeMm) {
    return Math.ceil((reachMm + SPACING.y) / edgeMm) + 2;
  }

  @Test
  void anEmptySegmentIsOutOfReachEverywhere() {
    SegmentDistance none = new SegmentDistance(new BitCube(14, 12, 16), GRID, REACH_MM);
    assertTrue(none.at(5, 5, 5) >= REACH_MM);
    assertTrue(none.at(-100, 5, 5) >= REACH_MM);
    assertTrue(none.body() < 0);
  }
}
