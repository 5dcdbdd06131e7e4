package org.palpate.benchmarks.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Compares the judge, which looks for a separating direction, with a search for edges of one cuboid
 * that cross the other one.
 */
class SolidOverlapTest {
  private static final long SEED = Long.getLong("palpate.seed", 20_261_128);
  private static final double CLOSE_MM = 1e-6;

  private final SplittableRandom random = new SplittableRandom(SEED);

  /** Returns a body of a few voxels of odd spacing at an odd pose. */
  private Body body() {
    BitCube bits = new BitCube(3, 4, 3);
    for (int n = 0; n < 3; n++) {
      bits.set(random.nextInt(3), random.nextInt(4), random.nextInt(3));
    }
    VoxelGrid grid = new VoxelGrid(3, 4, 3, new Vec3(0.7, 1, 1.9), RigidTransform.identity());
    Body body = new Body("odd", bits, grid, Mobility.FIXED);
    body.setPose(pose(1));
    return body;
  }

  private Pose pose(double reachMm) {
    Pose pose = new Pose();
    pose.translation.set(vector(reachMm));
    pose.rotation.setRotationVector(vector(2));
    return pose;
  }

  private Vec3 vector(double size) {
    return new Vec3(
        random.nextDouble(-size, size),
        random.nextDouble(-size, size),
        random.nextDouble(-size, size));
  }

  @Test
  void findsEveryOverlapOfCuboidsThatCrossingEdgesShow() {
    int overlapping = 0;
    int cases = 0;
    for (int n = 0; n < 3_000; n++) {
      Body body = body();
      BoxShape box = new BoxShape(length(), length(), length());
      Pose pose = pose(5);
      boolean surely = crosses(body, box, pose, -CLOSE_MM);
      if (surely == crosses(body, box, pose, CLOSE_MM)) {
        cases++;
        overlapping += surely ? 1 : 0;
        boolean found = SolidOverlap.ofBox(box).overlaps(new BodyScene(List.of(body)), pose);
        assertEquals(surely, found, "case " + n + " seed=" + SEED);
      }
    }
    assertTrue(overlapping > 200 && cases - overlapping > 300, overlapping + " of " + cases);
  }

  private double length() {
    return random.nextInt(4) == 0 ? random.nextDouble(4, 9) : random.nextDouble(0.05, 2);
  }

  @Test
  void needlesThatPassAVoxelAreSeparatedByCrossProductsOfEdges() {
    BitCube bits = new BitCube(1, 1, 1);
    bits.set(0, 0, 0);
    Body voxel = new Body("voxel", bits, VoxelGrid.ofUnitVoxels(1, 1, 1), Mobility.FIXED);
    BodyScene scene = new BodyScene(List.of(voxel));
    int overlapping = 0;
    for (int n = 0; n < 3_000; n++) {
      double[] edges = {0.02, 0.03, 0.04};
      edges[n % 3] = 8;
      BoxShape needle = new BoxShape(edges[0], edges[1], edges[2]);
      Pose pose = pose(1.2);
      boolean surely = crosses(voxel, needle, pose, -CLOSE_MM);
      if (surely == crosses(voxel, needle, pose, CLOSE_MM)) {
        overlapping += surely ? 1 : 0;
        boolean found = SolidOverlap.ofBox(needle).overlaps(scene, pose);
        assertEquals(surely, found, "case " + n + " seed=" + SEED);
      }
    }
    assertTrue(overlapping > 500 && overlapping < 2_500, "overlapping=" + overlapping);
  }

  @Test
  void findsEveryOverlapOfABallThatTheDistanceOfItsCentreShows() {
    int overlapping = 0;
    for (int n = 0; n < 3_000; n++) {
      Body body = body();
      Pose pose = pose(5);
      double distance = distanceMm(body, pose.translation);
      double radius = distance * random.nextDouble(0.8, 1.25);
      if (Math.abs(radius - distance) > CLOSE_MM) {
        overlapping += radius > distance ? 1 : 0;
        boolean found = SolidOverlap.ofBall(radius).overlaps(new BodyScene(List.of(body)), pose);
        assertEquals(radius > distance, found, "case " + n + " seed=" + SEED);
      }
    }
    assertTrue(overlapping > 300 && overlapping < 2_700, "overlapping=" + overlapping);
  }

  @Test
  void judgesEveryBodyOfASceneAndNoneWithoutVoxels() {
    Body empty =
        new Body("empty", new BitCube(3, 3, 3), VoxelGrid.ofUnitVoxels(3, 3, 3), Mobility.FIXED);
    BitCube bits = new BitCube(3, 3, 3);
    bits.set(2, 0, 1);
    Body far = new Body("far", bits, VoxelGrid.ofUnitVoxels(3, 3, 3), Mobility.FIXED);
    Pose away = new Pose();
    away.translation.set(40, 0, 0);
    far.setPose(away);
    SolidOverlap cube = SolidOverlap.ofBox(new BoxShape(1, 1, 1));
    Pose there = new Pose();
    there.translation.set(42.9, 0.5, 1.5);
    assertTrue(cube.overlaps(new BodyScene(List.of(empty, far)), there));
    assertFalse(cube.overlaps(new BodyScene(List.of(empty)), there));
    there.translation.set(2.9, 0.5, 1.5); // where the body was before it moved
    assertFalse(cube.overlaps(new BodyScene(List.of(empty, far)), there));
  }

  /** Whether an edge of the cuboid crosses a voxel that grew by a margin, or the reverse. */
  private static boolean crosses(Body body, BoxShape box, Pose pose, double marginMm) {
    double[] half = {box.edgeX() / 2, box.edgeY() / 2, box.edgeZ() / 2};
    Vec3 spacing = body.grid().spacingMm();
    double[] halfVoxel = {spacing.x / 2, spacing.y / 2, spacing.z / 2};
    for (int k = 0; k < body.bits().sizeZ(); k++) {
      for (int j = 0; j < body.bits().sizeY(); j++) {
        for (int i = 0; i < body.bits().sizeX(); i++) {
          if (body.bits().get(i, j, k)) {
            Pose voxel = new Pose().set(body.pose());
            Vec3 centre =
                new Vec3((i + 0.5) * spacing.x, (j + 0.5) * spacing.y, (k + 0.5) * spacing.z);
            body.pose().transform(centre, voxel.translation);
            if (anEdgeCrosses(pose, half, voxel, halfVoxel, marginMm)
                || anEdgeCrosses(voxel, halfVoxel, pose, half, marginMm)) {
              return true;
            }
          }
        }
      }
    }
    return false;
  }

  /** Whether an edge of the first cuboid crosses the second, or lies in it. */
  private static boolean anEdgeCrosses(
      Pose first, double[] half, Pose second, double[] otherHalf, double marginMm) {
    for (int axis = 0; axis < 3; axis++) {
      for (int corner = 0; corner < 4; corner++) {
        Vec3 from = new Vec3();
        from.set(axis, -half[axis]);
        from.set((axis + 1) % 3, (corner & 1) == 0 ? -half[(axis + 1) % 3] : half[(axis + 1) % 3]);
        from.set((axis + 2) % 3, (corner & 2) == 0 ? -half[(axis + 2) % 3] : half[(axis + 2) % 3]);
        Vec3 to = new Vec3().set(from);
        to.set(axis, half[axis]);
        second.inverseTransform(first.transform(from, from), from);
        second.inverseTransform(first.transform(to, to), to);
        if (crosses(from, to, otherHalf, marginMm)) {
          return true;
        }
      }
    }
    return false;
  }

  private static boolean crosses(Vec3 from, Vec3 to, double[] half, double marginMm) {
    double enter = 0;
    double leave = 1;
    for (int axis = 0; axis < 3; axis++) {
      double reach = half[axis] + marginMm;
      double along = to.get(axis) - from.get(axis);
      double low = (-reach - from.get(axis)) / along;
      double high = (reach - from.get(axis)) / along;
      enter = Math.max(enter, Math.min(low, high));
      leave = Math.min(leave, Math.max(low, high));
    }
    return enter <= leave;
  }

  private static double distanceMm(Body body, Vec3 world) {
    Vec3 at = body.pose().inverseTransform(world, new Vec3());
    Vec3 spacing = body.grid().spacingMm();
    double least = Double.POSITIVE_INFINITY;
    for (int k = 0; k < body.bits().sizeZ(); k++) {
      for (int j = 0; j < body.bits().sizeY(); j++) {
        for (int i = 0; i < body.bits().sizeX(); i++) {
          if (body.bits().get(i, j, k)) {
            double x = at.x - Math.max(i * spacing.x, Math.min((i + 1) * spacing.x, at.x));
            double y = at.y - Math.max(j * spacing.y, Math.min((j + 1) * spacing.y, at.y));
            double z = at.z - Math.max(k * spacing.z, Math.min((k + 1) * spacing.z, at.z));
            least = Math.min(least, Math.sqrt(x * x + y * y + z * z));
          }
        }
      }
    }
    return least;
  }
}
