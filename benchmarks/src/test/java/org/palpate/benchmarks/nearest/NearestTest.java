package org.palpate.benchmarks.nearest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

class NearestTest {
  private static final long SEED = Long.getLong("palpate.seed", 20_261_128);

  /** The distance of the points that the naive search looks at, voxels. */
  private static final double STEP = 0.125;

  private static BitCube noise(SplittableRandom random) {
    BitCube bits = new BitCube(4, 5, 4);
    for (int n = 0; n < 60; n++) {
      bits.set(random.nextInt(4), random.nextInt(5), random.nextInt(4));
    }
    return bits;
  }

  @Test
  void theOracleFindsWhatASearchOfAllPointsOfALatticeFinds() {
    SplittableRandom random = new SplittableRandom(SEED);
    int inside = 0;
    for (int n = 0; n < 20; n++) {
      BitCube bits = noise(random);
      Vec3 device = new Vec3(random.nextDouble(4), random.nextDouble(5), random.nextDouble(4));
      Vec3 from = new Vec3(-0.5, 2, random.nextDouble(4));
      double radius = random.nextDouble(1, 4);
      double all = searched(bits, device, device, 99);
      double atMost = searched(bits, device, from, radius);
      double atLeast = searched(bits, device, from, radius + 2 * STEP) - 2 * STEP;
      NearestFreeOracle oracle = new NearestFreeOracle(bits);
      double distance = oracle.distance(device);
      inside += distance > 0 ? 1 : 0;
      assertTrue(distance <= all + 1e-12 && distance > all - 2 * STEP, distance + " " + all);
      double limited = oracle.distance(device, from, radius);
      assertTrue(limited <= atMost + 1e-12, limited + " but a point lies at " + atMost);
      assertTrue(limited > atLeast, limited + " but points begin at " + atLeast);
    }
    assertTrue(inside > 5, "inside=" + inside);
  }

  /** Returns the distance to the nearest lattice point in an empty voxel within a ball. */
  private static double searched(BitCube bits, Vec3 device, Vec3 from, double radius) {
    double least = Double.POSITIVE_INFINITY;
    for (double z = -1; z <= 5; z += STEP) {
      for (double y = -1; y <= 6; y += STEP) {
        for (double x = -1; x <= 5; x += STEP) {
          Vec3 at = new Vec3(x, y, z);
          if (isInEmpty(bits, at) && at.sub(from, new Vec3()).length() <= radius) {
            least = Math.min(least, at.sub(device, at).length());
          }
        }
      }
    }
    return least;
  }

  /** Whether one of the up to eight closed voxels around a point is empty. */
  private static boolean isInEmpty(BitCube bits, Vec3 at) {
    for (int n = 0; n < 8; n++) {
      double i = (n & 1) == 0 ? Math.floor(at.x) : Math.ceil(at.x) - 1;
      double j = (n & 2) == 0 ? Math.floor(at.y) : Math.ceil(at.y) - 1;
      double k = (n & 4) == 0 ? Math.floor(at.z) : Math.ceil(at.z) - 1;
      if (!bits.get((int) i, (int) j, (int) k)) {
        return true;
      }
    }
    return false;
  }

  @Test
  void aDeviceInAPlateIsAsDeepAsItsNearerFace() {
    BitCube bits = new BitCube(9, 9, 9);
    for (int n = 0; n < 81; n++) {
      for (int k = 2; k < 6; k++) {
        bits.set(n % 9, n / 9, k);
      }
    }
    NearestFreeOracle oracle = new NearestFreeOracle(bits);
    assertEquals(1.25, oracle.distance(new Vec3(4, 4, 3.25)), 1e-15);
    assertEquals(0.5, oracle.distance(new Vec3(4, 4, 5.5)), 1e-15);
    assertEquals(0, oracle.distance(new Vec3(4, 4, 6)));
    Vec3 above = new Vec3(4, 4, 8);
    assertEquals(2.75, oracle.distance(new Vec3(4, 4, 3.25), above, 4), 1e-15);
    assertEquals(
        Double.POSITIVE_INFINITY, oracle.distance(new Vec3(4, 4, 3.25), new Vec3(4, 4, 4), 0.5));
  }

  @Test
  void theCornerOfAVoxelThatReachesIntoTheBallIsFoundAlthoughItsNearestPointDoesNot() {
    BitCube bits = new BitCube(9, 9, 9);
    for (int n = 0; n < 729; n++) {
      bits.set(n % 9, n / 9 % 9, n / 81);
    }
    bits.clear(6, 4, 4);
    Vec3 device = new Vec3(4.5, 4.5, 4.5);
    Vec3 from = new Vec3(6.5, 7.5, 4.5);
    NearestFreeOracle oracle = new NearestFreeOracle(bits);
    assertEquals(1.5, oracle.distance(device), 1e-12);
    assertEquals(1.5, oracle.distance(device, from, Math.sqrt(9.25)), 1e-9);
    double radius = Math.hypot(2.5, 0.2); // reaches the edge y = 5 from x = 6.3 on
    assertEquals(Math.hypot(1.8, 0.5), oracle.distance(device, from, radius), 1e-9);
    assertEquals(Double.POSITIVE_INFINITY, oracle.distance(device, from, 1.4), "only solids");
  }

  @Test
  void aPressGoesStraightInToItsDepthAndStaysThere() {
    PressedSolid ball = PressedSolid.all().get(2);
    for (double depth : new double[] {0.5, 3, 10}) {
      SplittableRandom random = new SplittableRandom(SEED);
      List<Vec3> hand = PressTrajectory.positions(ball, depth, random);
      assertEquals(3, ball.truth().signedDistance(hand.get(0)), 1e-9);
      double last = 3.1;
      boolean arrived = false;
      Vec3 before = new Vec3().set(hand.get(0));
      for (Vec3 at : hand) {
        assertTrue(
            at.sub(before, before).length() < 0.3 + 1e-9, "no step is longer than the speed");
        before.set(at);
        double height = ball.truth().signedDistance(at);
        arrived |= height <= -depth + 1e-9;
        assertTrue(arrived ? Math.abs(height + depth) < 1e-9 : height < last, "height=" + height);
        last = height;
      }
      assertTrue(arrived);
      Vec3 step = hand.get(1).sub(hand.get(0), new Vec3());
      assertEquals(0.3, step.length(), 1e-9);
    }
  }

  @Test
  void aPressDependsOnTheRandomNumbersAlone() {
    PressedSolid box = PressedSolid.all().get(0);
    List<Vec3> one = PressTrajectory.positions(box, 3, new SplittableRandom(SEED));
    List<Vec3> same = PressTrajectory.positions(box, 3, new SplittableRandom(SEED));
    List<Vec3> other = PressTrajectory.positions(box, 3, new SplittableRandom(SEED + 1));
    assertEquals(one.size(), same.size());
    for (int n = 0; n < one.size(); n++) {
      assertTrue(one.get(n).sameBits(same.get(n)));
    }
    assertTrue(!one.get(0).sameBits(other.get(0)));
  }

  @Test
  void theRowOfASolverFollowsTheColumns() {
    assertEquals(
        List.of("ball", 3.0, "guarded", 0.25, 0.5, 60),
        new NearestRow("ball", 3, "guarded", 0.25, 0.5, 60).cells());
  }
}
