package org.palpate.benchmarks.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.BitCube;

class HostileDeviceTest {
  private static final long SEED = Long.getLong("palpate.seed", 20_261_128);
  private static final double REACH_MM = 30;

  private static List<Pose> reports(long seed, int frames) {
    HostileDevice device = new HostileDevice(new SplittableRandom(seed), 0.5, REACH_MM);
    List<Pose> reports = new ArrayList<>();
    for (int frame = 0; frame < frames; frame++) {
      reports.add(new Pose().set(device.next()));
    }
    return reports;
  }

  @Test
  void theSeedAloneDecidesOnTheReports() {
    List<Pose> reports = reports(SEED, 2_000);
    List<Pose> same = reports(SEED, 2_000);
    List<Pose> other = reports(SEED + 1, 2_000);
    int differing = 0;
    for (int n = 0; n < reports.size(); n++) {
      assertTrue(reports.get(n).sameBits(same.get(n)), "frame=" + n);
      differing += reports.get(n).sameBits(other.get(n)) ? 0 : 1;
    }
    assertTrue(differing > 1_900, "differing=" + differing);
  }

  @Test
  void whatIsAPoseStaysWithinReachAndWhatIsNoneComesOneFrameInFifty() {
    int none = 0;
    int far = 0;
    for (Pose report : reports(SEED, 20_000)) {
      boolean isPose = report.isFinite() && report.rotation.isNearUnit();
      none += isPose ? 0 : 1;
      far += isPose && report.translation.z == 1e12 ? 1 : 0;
      for (int axis = 0; isPose && report.translation.z != 1e12 && axis < 3; axis++) {
        assertTrue(Math.abs(report.translation.get(axis)) <= REACH_MM, report.toString());
      }
    }
    assertTrue(none > 350 && none < 650, "none=" + none); // 5 of 200
    assertTrue(far > 60 && far < 150, "far=" + far);
  }

  @Test
  void theDeviceRestsInEveryFourthPhaseAndFlipsTheSignOfEveryThirdRotation() {
    List<Pose> reports = reports(SEED, 160);
    int resting = 0;
    int flipped = 0;
    for (int n = 121; n < 160; n++) {
      Pose a = reports.get(n - 1);
      Pose b = reports.get(n);
      resting += a.translation.sameBits(b.translation) ? 1 : 0;
      flipped += a.rotation.dot(b.rotation) < 0 ? 1 : 0;
    }
    assertTrue(resting >= 34, "resting=" + resting);
    assertTrue(flipped >= 20 && flipped <= 28, "flipped=" + flipped);
  }

  @Test
  void theKeepOutFindsTheNearestOfAllCellsToALine() {
    SplittableRandom random = new SplittableRandom(SEED);
    BitCube bits = new BitCube(5, 5, 5);
    for (int n = 0; n < 6; n++) {
      bits.set(random.nextInt(5), random.nextInt(5), random.nextInt(5));
    }
    KeepOut keepOut = new KeepOut(SurfaceScene.scene(bits), ToolSampler.point(), Clearance.POINTS);
    for (int n = 0; n < 30; n++) {
      Vec3 origin = vector(random, 8);
      Vec3 axis = vector(random, 1);
      axis.mul(1 / axis.length(), axis);
      double searched = searched(bits, origin, axis);
      double found = keepOut.distanceFromLineMm(origin, axis);
      assertTrue(found <= searched + 1e-6, found + " but a point lies at " + searched);
      assertTrue(found > searched - 0.2, found + " but points begin at " + searched);
    }
  }

  private static Vec3 vector(SplittableRandom random, double size) {
    return new Vec3(
        random.nextDouble(-size, size),
        random.nextDouble(-size, size),
        random.nextDouble(-size, size));
  }

  /** Returns the least distance of the points of a lattice in the solid voxels from a line. */
  private static double searched(BitCube bits, Vec3 origin, Vec3 axis) {
    double least = Double.POSITIVE_INFINITY;
    for (int n = 0; n < 40 * 40 * 40; n++) {
      int i = n % 40;
      int j = n / 40 % 40;
      int k = n / 1_600;
      if (bits.get(i / 8, j / 8, k / 8)) {
        Vec3 at = new Vec3(onLattice(i), onLattice(j), onLattice(k));
        at.sub(origin, at);
        double along = at.dot(axis);
        least = Math.min(least, Math.sqrt(Math.max(0, at.dot(at) - along * along)));
      }
    }
    return least;
  }

  /** Returns the coordinate of one of the eight lattice points from face to face of a voxel. */
  private static double onLattice(int n) {
    return Math.floorDiv(n, 8) + n % 8 / 7.0;
  }

  @Test
  void aBallRollsOnTheSurfaceAtTheHeightOfItsRadius() {
    SurfaceScene scene = SurfaceScene.of("sphere", 64);
    OffsetSurface offset = new OffsetSurface(scene.truth(), 4);
    Vec3 point = new Vec3();
    Vec3 normal = new Vec3();
    scene.landing(point, normal);
    assertEquals(0, scene.truth().signedDistance(point), 1e-9);
    normal.mul(4, new Vec3()).add(point, point);
    assertEquals(0, offset.signedDistance(point), 1e-9);
    assertEquals(1, offset.normal(point, new Vec3()).dot(normal), 1e-12);
  }
}
