package org.palpate.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.PointSet;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.Ray;
import org.palpate.testing.ExactOracle;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

/** The CPU is the reference for other devices, so its answers are compared with exact fractions. */
class CpuCollisionDeviceTest {
  private static final int SIZE = 10;
  private static final int POINTS = 40;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final BitCube bits = new BitCube(SIZE, SIZE, SIZE);
  private final Vec3[] points = new Vec3[POINTS];
  private final MotionGroup motions = new MotionGroup();

  CpuCollisionDeviceTest() {
    for (int n = 0; n < 25; n++) {
      bits.set(random.nextInt(SIZE), random.nextInt(SIZE), random.nextInt(SIZE));
    }
    for (int n = 0; n < POINTS; n++) {
      points[n] = new Vec3(random.nextDouble(), random.nextDouble(), random.nextDouble());
    }
  }

  private LegBatch batch() {
    return CollisionDevice.CPU
        .keep(bits)
        .newBatch(
            new PointSet() {
              @Override
              public int count() {
                return POINTS;
              }

              @Override
              public double x(int point) {
                return points[point].x;
              }

              @Override
              public double y(int point) {
                return points[point].y;
              }

              @Override
              public double z(int point) {
                return points[point].z;
              }
            });
  }

  private AffineMap randomMap() {
    Pose pose = new Pose();
    pose.translation.set(random.nextDouble(SIZE), random.nextDouble(SIZE), random.nextDouble(SIZE));
    pose.rotation.setRotationVector(
        new Vec3(random.nextDouble(2), random.nextDouble(2), random.nextDouble(2)));
    return new AffineMap().set(pose);
  }

  private Vec3 image(AffineMap map, int point) {
    return map.transform(points[point], new Vec3());
  }

  @Test
  void aVerdictIsThatOfTheExactSegmentBetweenTheImages() {
    LegBatch batch = batch();
    int hits = 0;
    for (int round = 0; round < 30; round++) {
      AffineMap start = randomMap();
      AffineMap[] ends = {randomMap(), randomMap()};
      motions.begin(start);
      motions.add(ends[0]);
      motions.add(ends[1]);
      assertTrue(batch.judge(motions));
      for (int motion = 0; motion < 2; motion++) {
        for (int point = 0; point < POINTS; point++) {
          Vec3 from = image(start, point);
          Vec3 to = image(ends[motion], point);
          Ray leg = new Ray().from(from.x, from.y, from.z).to(to.x, to.y, to.z);
          boolean touches = !Double.isNaN(ExactOracle.firstTouch(bits, leg));
          hits += touches ? 1 : 0;
          assertEquals(
              touches ? LegVerdict.HIT : LegVerdict.FREE,
              batch.verdict(motion, point),
              () -> "seed " + Seeds.seed() + " " + leg);
        }
      }
    }
    assertTrue(hits > 200 && hits < 2_000, "hits: " + hits);
  }

  @Test
  void verdictsAreThoseOfTheMotionsAsTheyWereWhenTheyWereJudged() {
    bits.set(9, 9, 9);
    points[0].set(0, 0, 0);
    LegBatch batch = batch();
    AffineMap start = new AffineMap();
    start.set(Pose.at(30, 30, 30));
    AffineMap near = new AffineMap().set(Pose.at(9.5, 9.5, 9.5));
    motions.begin(start);
    motions.add(near);
    batch.judge(motions);
    assertEquals(LegVerdict.HIT, batch.verdict(0, 0));
    motions.begin(start);
    motions.add(new AffineMap().set(Pose.at(60, 60, 60)));
    assertEquals(LegVerdict.HIT, batch.verdict(0, 0), "not judged yet");
    batch.judge(motions);
    assertEquals(LegVerdict.FREE, batch.verdict(0, 0));
  }

  /** The distance to the nearest closed voxel, by the largest component, bounds the cube. */
  @Test
  void theEmptyCubeAroundAPointTouchesNoVoxelAndIsNeverFarTooSmall() {
    LegBatch batch = batch();
    int found = 0;
    for (int round = 0; round < 50; round++) {
      AffineMap start = randomMap();
      motions.begin(start);
      motions.add(start);
      batch.judge(motions);
      for (int point = 0; point < POINTS; point++) {
        double free = chebyshevDistance(image(start, point));
        double half = batch.emptyAround(point);
        assertTrue(half == 0 || half < free, "half " + half + " of " + free);
        assertTrue(half >= Math.min(free / 2, 2) || free < 0.5, "half " + half + " of " + free);
        found += half > 0 ? 1 : 0;
      }
    }
    assertTrue(found > 500, "found: " + found);
  }

  private double chebyshevDistance(Vec3 at) {
    double least = Double.POSITIVE_INFINITY;
    for (int k = 0; k < SIZE; k++) {
      for (int j = 0; j < SIZE; j++) {
        for (int i = 0; i < SIZE; i++) {
          if (bits.get(i, j, k)) {
            double distance =
                Math.max(outside(at.x, i), Math.max(outside(at.y, j), outside(at.z, k)));
            least = Math.min(least, distance);
          }
        }
      }
    }
    return least;
  }

  private static double outside(double coordinate, int cell) {
    return Math.max(0, Math.max(cell - coordinate, coordinate - (cell + 1)));
  }

  @Test
  void theCpuIsNeverFasterThanItselfAndJudgesOneMotionAtATime() {
    assertEquals(LegBatch.NEVER, batch().crossover());
    assertEquals(1, batch().motionsAtOnce());
    assertEquals("cpu", CollisionDevice.CPU.name());
    assertEquals(Optional.empty(), CollisionDevice.CPU.failure());
    assertEquals(0, CollisionDevice.CPU.batches());
  }

  @Test
  void aChangedVoxelCountsAtOnceAndAClosedDeviceGoesOn() {
    bits.clear(0, 0, 0);
    points[0].set(0, 0, 0);
    LegBatch batch = batch();
    motions.begin(new AffineMap().set(Pose.at(-3, 0.5, 0.5)));
    motions.add(new AffineMap().set(Pose.at(0.5, 0.5, 0.5)));
    batch.judge(motions);
    assertEquals(LegVerdict.FREE, batch.verdict(0, 0));
    bits.set(0, 0, 0);
    CollisionDevice.CPU.keep(bits).voxelsChanged(new IntBox());
    CollisionDevice.CPU.close();
    assertEquals(LegVerdict.HIT, batch.verdict(0, 0));
  }

  @Test
  void aGroupKnowsTheMotionsThatItHolds() {
    AffineMap start = randomMap();
    AffineMap first = randomMap();
    AffineMap second = randomMap();
    motions.begin(start);
    assertEquals(MotionGroup.NONE, motions.indexOf(start, first));
    motions.add(first);
    motions.add(second);
    assertEquals(0, motions.indexOf(start, first));
    assertEquals(1, motions.indexOf(start, second));
    assertEquals(MotionGroup.NONE, motions.indexOf(first, second));
    assertEquals(MotionGroup.NONE, motions.indexOf(start, start));
    MotionGroup copy = new MotionGroup();
    copy.set(motions);
    assertEquals(2, copy.count());
    assertTrue(copy.from().sameBits(start) && copy.to(1).sameBits(second));
    assertSame(motions.to(0), motions.to(0));
    motions.begin(second);
    assertEquals(0, motions.count());
    assertEquals(MotionGroup.NONE, motions.indexOf(second, first));
  }
}
