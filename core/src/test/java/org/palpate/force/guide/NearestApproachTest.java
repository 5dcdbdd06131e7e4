package org.palpate.force.guide;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** The nearest approach of a tool, against the distance of every point from every voxel. */
class NearestApproachTest {
  private static final Vec3 SPACING = new Vec3(1, 1.5, 0.8);
  private static final double REACH_MM = 9;

  private static final VoxelGrid GRID =
      new VoxelGrid(
          16,
          14,
          18,
          SPACING,
          new RigidTransform(
              new Vec3(0, 1, 0), new Vec3(-1, 0, 0), new Vec3(0, 0, 1), new Vec3(3, -2, 5)));

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final BitCube solids = new BitCube(16, 14, 18);
  private final NearestApproach approach;

  NearestApproachTest() {
    for (int n = 0; n < 12; n++) {
      solids.set(random.nextInt(5, 9), random.nextInt(5, 9), random.nextInt(6, 11));
    }
    approach = approach();
  }

  private NearestApproach approach() {
    return new NearestApproach("nerve", 1.5, solids, GRID, REACH_MM);
  }

  /** Returns the distance of a point from the nearest voxel as a closed box, mm. */
  private double distanceMm(Vec3 grid) {
    double least = Double.POSITIVE_INFINITY;
    for (int n = 0; n < 16 * 14 * 18; n++) {
      int i = n % 16;
      int j = n / 16 % 14;
      int k = n / (16 * 14);
      if (solids.get(i, j, k)) {
        double x = gap(grid.x, i) * SPACING.x;
        double y = gap(grid.y, j) * SPACING.y;
        double z = gap(grid.z, k) * SPACING.z;
        least = Math.min(least, Math.sqrt(x * x + y * y + z * z));
      }
    }
    return least;
  }

  private static double gap(double at, int cell) {
    return at < cell ? cell - at : at > cell + 1 ? at - cell - 1 : 0;
  }

  private Vec3 anywhere() {
    return new Vec3(
        random.nextDouble(-4, 20), random.nextDouble(-4, 18), random.nextDouble(-4, 22));
  }

  @Test
  void aRecordWithoutFramesHasNoDistance() {
    assertEquals(-1, approach.frame());
    assertEquals(OptionalDouble.empty(), approach.nearestMm());
    assertEquals("nerve", approach.segment());
    assertEquals(1.5, approach.marginMm());
  }

  @Test
  void aPointOutOfReachIsNotNoted() {
    approach.notePoint(new Vec3(-40, 7, 7), 3);
    assertEquals(-1, approach.frame());
    assertEquals(OptionalDouble.empty(), approach.nearestMm());
  }

  /** Interpolation between the middles of voxels decides, which errs by less than a voxel. */
  @Test
  void theNearestOfManyPointsIsNotedWithItsFrameAndItsExactDistance() {
    int judged = 0;
    for (int round = 0; round < 40; round++) {
      NearestApproach record = approach();
      Vec3[] points = new Vec3[30];
      double nearest = Double.POSITIVE_INFINITY;
      for (int frame = 0; frame < points.length; frame++) {
        points[frame] = anywhere();
        nearest = Math.min(nearest, distanceMm(points[frame]));
        record.notePoint(points[frame], 100 + frame);
      }
      if (nearest > REACH_MM - 2) {
        continue;
      }
      judged++;
      int noted = (int) record.frame() - 100;
      double mm = record.nearestMm().orElseThrow();
      assertEquals(distanceMm(points[noted]), mm, 1e-12, "seed " + Seeds.seed());
      assertTrue(mm < nearest + 1.5, mm + " but a point came to " + nearest);
    }
    assertTrue(judged > 30, "rounds in reach: " + judged);
  }

  @Test
  void theFirstOfEqualApproachesCounts() {
    Vec3 near = new Vec3(3, 7, 8);
    approach.notePoint(near, 5);
    double mm = approach.nearestMm().orElseThrow();
    approach.notePoint(near, 6);
    approach.notePoint(new Vec3(1, 7, 8), 7);
    assertEquals(5, approach.frame());
    assertEquals(mm, approach.nearestMm().orElseThrow());
  }

  @Test
  void aPointInAVoxelHasTheDistanceZero() {
    int[] voxel = new int[3];
    solids.forEachRimVoxel(
        (i, j, k) -> {
          voxel[0] = i;
          voxel[1] = j;
          voxel[2] = k;
        });
    approach.notePoint(new Vec3(voxel[0] + 0.5, voxel[1] + 0.5, voxel[2] + 0.5), 0);
    assertEquals(0, approach.frame());
    assertEquals(0, approach.nearestMm().orElseThrow());
  }

  /** A tool is as near as the nearest of its points, wherever it is turned. */
  @Test
  void aToolIsAsNearAsTheNearestOfItsPoints() {
    RigidTool tool = ToolSampler.ofShape(new BoxShape(5, 3, 7), 0.4);
    assertTrue(tool.tree().nodes() > 20, "a tree of several levels");
    int found = 0;
    for (int round = 0; round < 120; round++) {
      NearestApproach record = approach();
      NearestApproach pointByPoint = approach();
      for (int frame = 0; frame < 4; frame++) {
        Pose pose = randomPose();
        record.noteTool(tool, pose, frame);
        for (int n = 0; n < tool.count(); n++) {
          Vec3 p = pose.transform(tool.point(n, new Vec3()), new Vec3());
          pointByPoint.notePoint(GRID.worldToGrid(p, p), frame);
        }
      }
      assertEquals(pointByPoint.frame(), record.frame(), "seed " + Seeds.seed());
      assertEquals(pointByPoint.nearestMm().isPresent(), record.nearestMm().isPresent());
      if (record.frame() >= 0) {
        found++;
        assertEquals(
            pointByPoint.nearestMm().getAsDouble(), record.nearestMm().getAsDouble(), 1e-9);
      }
    }
    assertTrue(found > 40, "tools in reach: " + found);
  }

  private Pose randomPose() {
    Pose pose = new Pose();
    GRID.gridToWorld(anywhere(), pose.translation);
    pose.rotation.setRotationVector(
        new Vec3(random.nextDouble(-2, 2), random.nextDouble(-2, 2), random.nextDouble(-2, 2)));
    return pose;
  }
}
