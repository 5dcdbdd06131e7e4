package org.palpate.force.guide;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.force.EffectSite;
import org.palpate.force.HandState;
import org.palpate.force.HapticEffect;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

class SegmentPushTest {
  private static final long SEED = Seeds.seed();
  private static final int EDGE = 20;
  private static final double REACH_MM = 6;
  private static final VoxelGrid GRID =
      new VoxelGrid(EDGE, EDGE, EDGE, new Vec3(1, 0.75, 2), RigidTransform.identity());
  private static final GuideStrength STRENGTH =
      new GuideStrength(OptionalDouble.of(0.5), OptionalDouble.of(100), Double.POSITIVE_INFINITY);

  private final SplittableRandom random = new SplittableRandom(SEED);
  private final HandState hand = new HandState();
  private final Vec3 force = new Vec3();
  private final Vec3 torque = new Vec3();

  private BitCube randomVoxels(int count) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int n = 0; n < count; n++) {
      bits.set(random.nextInt(EDGE), random.nextInt(EDGE), random.nextInt(EDGE));
    }
    return bits;
  }

  private static BitCube wall() {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int j = 0; j < EDGE; j++) {
      for (int k = 0; k < EDGE; k++) {
        bits.set(0, j, k);
      }
    }
    return bits;
  }

  /** Returns the distance of a position from the nearest voxel, by looking at every one. */
  private static double naive(BitCube bits, double x, double y, double z) {
    double least = REACH_MM + 2;
    for (int k = 0; k < EDGE; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = 0; i < EDGE; i++) {
          if (bits.get(i, j, k)) {
            double gapX = Math.max(0, Math.max(i - x, x - i - 1));
            double gapY = 0.75 * Math.max(0, Math.max(j - y, y - j - 1));
            double gapZ = 2 * Math.max(0, Math.max(k - z, z - k - 1));
            least = Math.min(least, Math.sqrt(gapX * gapX + gapY * gapY + gapZ * gapZ));
          }
        }
      }
    }
    return least;
  }

  @Test
  void distancesOfMiddlesOfVoxelsAreThoseOfTheNearestSolidVoxel() {
    for (int round = 0; round < 4; round++) {
      BitCube bits = randomVoxels(1 + 5 * round);
      SegmentDistance distance = new SegmentDistance(bits, GRID, REACH_MM);
      for (int k = -3; k < EDGE + 3; k++) {
        for (int j = -3; j < EDGE + 3; j++) {
          for (int i = -3; i < EDGE + 3; i++) {
            double expected = naive(bits, i + 0.5, j + 0.5, k + 0.5);
            double found = distance.at(i + 0.5, j + 0.5, k + 0.5);
            assertEquals(expected, found, 1e-5, "seed " + SEED + " at " + i + "," + j + "," + k);
          }
        }
      }
    }
  }

  @Test
  void distancesAreContinuousAndNearTheTrueOnes() {
    BitCube bits = randomVoxels(8);
    SegmentDistance distance = new SegmentDistance(bits, GRID, REACH_MM);
    for (int n = 0; n < 20_000; n++) {
      double x = random.nextDouble() * (EDGE + 16) - 8;
      double y = random.nextDouble() * (EDGE + 16) - 8;
      double z = random.nextDouble() * (EDGE + 16) - 8;
      double at = distance.at(x, y, z);
      assertEquals(naive(bits, x, y, z), at, 1.2, "seed " + SEED);
      assertEquals(at, distance.at(x + 1e-6, y - 1e-6, z + 1e-6), 1e-5, "seed " + SEED);
    }
  }

  @Test
  void anEmptySegmentIsFarFromEverything() {
    SegmentDistance distance = new SegmentDistance(new BitCube(EDGE, EDGE, EDGE), GRID, REACH_MM);
    assertEquals(REACH_MM + 2, distance.at(3, 4, 5));
  }

  @Test
  void aBoxOfTooManyVoxelsIsRefused() {
    BitCube bits = new BitCube(400, 400, 400);
    bits.set(0, 0, 0);
    bits.set(399, 399, 399);
    VoxelGrid large = VoxelGrid.ofUnitVoxels(400, 400, 400);
    assertThrows(IllegalArgumentException.class, () -> new SegmentDistance(bits, large, 1));
  }

  private HapticEffect away(BitCube bits, double marginMm, Vec3... points) {
    EffectSite site =
        new EffectSite(GRID.gridMmToWorld(), 0.5, 8, Double.POSITIVE_INFINITY, List.of(points));
    return Guides.away(new SegmentDistance(bits, GRID, REACH_MM), marginMm, STRENGTH).make(site);
  }

  private Vec3 feel(HapticEffect guide) {
    force.set(0, 0, 0);
    torque.set(0, 0, 0);
    guide.add(hand, force, torque);
    return force;
  }

  @Test
  void aSegmentThatIsABodyPushesFromWhereTheBodyIs() {
    EffectSite site =
        new EffectSite(GRID.gridMmToWorld(), 0.5, 8, Double.POSITIVE_INFINITY, List.of(new Vec3()));
    HapticEffect guide =
        Guides.away(new SegmentDistance(wall(), GRID, REACH_MM, 1), 4, STRENGTH).make(site);
    Quaternion quarter = new Quaternion().setRotationVector(new Vec3(0, 0, Math.PI / 2));
    Pose pose = new Pose().set(new Vec3(100, 50, 0), quarter);
    hand.bodyPoses = List.of(new Pose(), pose);
    pose.transform(new Vec3(3, 7, 20), hand.tool.translation);
    assertEquals(0.5 * 2, feel(guide).y, 1e-6, "the wall faces y now");
    assertEquals(0, Math.hypot(force.x, force.z), 1e-6);
    hand.tool.translation.set(3, 7, 20);
    assertEquals(0, feel(guide).length(), "the body is away");
    hand.bodyPoses = List.of();
    assertEquals(0.5 * 2, feel(guide).x, 1e-6);
  }

  @Test
  void thePushGrowsFromTheEdgeOfTheMargin() {
    HapticEffect guide = away(wall(), 4, new Vec3());
    hand.tool.translation.set(5.01, 7, 20);
    assertEquals(0, feel(guide).length());
    hand.tool.translation.set(3, 7, 20);
    assertEquals(0.5 * 2, feel(guide).x, 1e-6);
    assertEquals(0, Math.hypot(force.y, force.z), 1e-6);
    assertEquals(0, torque.length());
  }

  @Test
  void theDeepestPointOfAToolCountsAndItsLeverTurnsTheTool() {
    hand.isRigid = true;
    HapticEffect guide = away(wall(), 4, new Vec3(-2, 0, 0), new Vec3(0, 3, 0));
    hand.tool.translation.set(5.5, 7, 20);
    feel(guide);
    assertEquals(0.5 * 1.5, force.x, 1e-6); // only the first point is in the margin, 1.5 mm deep
    assertEquals(0, torque.length(), 1e-6);
    hand.tool.rotation.setRotationVector(new Vec3(0, 0, Math.PI / 2)); // (0,3,0) is now (-3,0,0)
    feel(guide);
    assertEquals(0.5 * 2.5, force.x, 1e-6);
    assertEquals(0, torque.length(), 1e-6);
    hand.tool.rotation.setRotationVector(new Vec3(0, 0, Math.PI / 4));
    feel(guide);
    double depth = 4 - (5.5 - 3 * Math.sqrt(0.5) - 1);
    double other = 4 - (5.5 - 2 * Math.sqrt(0.5) - 1);
    double newton = 0.5 * depth;
    assertEquals(newton, force.x, 1e-5);
    double leverY = (depth * 3 * Math.sqrt(0.5) - other * 2 * Math.sqrt(0.5)) / (depth + other);
    assertEquals(-leverY * newton, torque.z, 1e-4);
  }

  @Test
  void aBodyInHandFeelsNothing() {
    HapticEffect guide = away(wall(), 4, new Vec3());
    hand.tool.translation.set(3, 7, 20);
    hand.heldBody = 0;
    assertEquals(0, feel(guide).length());
  }

  @Test
  void aToolThatSlidesThroughMarginsFeelsNoStep() {
    hand.isRigid = true;
    Vec3[] points = new Vec3[30];
    for (int n = 0; n < points.length; n++) {
      points[n] =
          new Vec3(random.nextDouble() * 4 - 2, random.nextDouble() * 4 - 2, random.nextDouble());
    }
    HapticEffect guide = away(randomVoxels(12), 5, points);
    Vec3 lastForce = new Vec3();
    Vec3 lastTorque = new Vec3();
    double stepMm = 0.005;
    for (int n = 0; n < 8000; n++) {
      hand.tool.translation.set(-10 + n * stepMm, 8 + 0.1 * Math.sin(0.001 * n), 18);
      feel(guide);
      if (n > 0) {
        double change = force.sub(lastForce, lastForce).length();
        double turning = torque.sub(lastTorque, lastTorque).length();
        assertTrue(change <= 0.03, "seed " + SEED + " frame " + n + " force changed by " + change);
        assertTrue(turning <= 0.15, "seed " + SEED + " frame " + n + " by N mm " + turning);
      }
      lastForce.set(force);
      lastTorque.set(torque);
    }
  }
}
