package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.GrownSolids;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.Ray;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.testing.ExactOracle;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class BlockingVoxelsTest {
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @Test
  void findsExactlyTheVoxelsThatRationalArithmeticFinds() {
    int blocked = 0;
    for (int round = 0; round < 60; round++) {
      BodyScene scene = ToolScenes.clutter(random, 1 + round % 2);
      RigidTool tool = ToolScenes.tool(random).thinned(40);
      Clearance[] clearances = new Clearance[scene.count()];
      for (int n = 0; n < clearances.length; n++) {
        clearances[n] = round % 3 == 0 ? Clearance.POINTS : new Clearance(0.6, 0.72, 2);
      }
      MoverVerifier verifier = ToolScenes.verifier(scene, tool, clearances, true);
      Pose start = RandomGeometry.pose(random, 20);
      while (!verifier.place(start, false)) {
        start = RandomGeometry.pose(random, 40);
      }
      BlockingVoxels blocking = new BlockingVoxels(scene, tool, verifier);
      for (int step = 0; step < 60; step++) {
        Pose device = new Pose().set(verifier.pose());
        Vec3 off = RandomGeometry.vector(random, 4).sub(device.translation, new Vec3());
        off.mul(random.nextDouble(0.3), off);
        device.displace(off, RandomGeometry.vector(random, 0.3), 1, new Quaternion(), device);
        Set<String> expected = naive(scene, tool, verifier, device);
        Set<String> found = removeAll(scene, verifier, blocking, device);
        assertEquals(expected, found, "seed " + Seeds.seed() + " round " + round);
        blocked += found.isEmpty() ? 0 : 1;
        moveTo(limited(scene, tool, verifier.pose(), device), verifier);
      }
    }
    assertTrue(blocked > 60, "blocked " + blocked);
  }

  @Test
  void meetsExactlyTheVoxelsThatRationalArithmeticFinds() {
    int met = 0;
    for (int round = 0; round < 30; round++) {
      BodyScene scene = ToolScenes.clutter(random, 1);
      RigidTool tool = ToolScenes.tool(random).thinned(40);
      Clearance clearance = round % 3 == 0 ? Clearance.POINTS : new Clearance(0.6, 0.72, 2);
      MoverVerifier verifier = ToolScenes.verifier(scene, tool, new Clearance[] {clearance}, true);
      Pose start = RandomGeometry.pose(random, 20);
      while (!verifier.place(start, false)) {
        start = RandomGeometry.pose(random, 40);
      }
      BlockingVoxels blocking = new BlockingVoxels(scene, tool, verifier);
      BitCube bits = scene.body(0).bits();
      List<int[]> touched = touchedCells(verifier.pair(0), tool);
      for (int k = 0; k < bits.sizeZ(); k++) {
        for (int j = 0; j < bits.sizeY(); j++) {
          for (int i = 0; i < bits.sizeX(); i++) {
            boolean expected =
                naiveMeets(verifier.pair(0).levels, touched, i, j, k)
                    || naiveEncloses(verifier, tool, clearance, i, j, k);
            assertEquals(expected, blocking.meets(0, i, j, k), "seed " + Seeds.seed());
            met += expected ? 1 : 0;
          }
        }
      }
    }
    assertTrue(met > 100, "met " + met);
  }

  /** Returns the cells that points of the tool touch: level, x, y, z. */
  private static List<int[]> touchedCells(BodyVerifier verifier, RigidTool tool) {
    List<int[]> touched = new ArrayList<>();
    for (int point = 0; point < tool.count(); point++) {
      int level = verifier.level(point);
      AffineMap map = verifier.levels.toCells(verifier.from(), level, new AffineMap());
      Vec3 p = map.transform(tool.point(point, new Vec3()), new Vec3());
      Ray rest = new Ray().from(p.x, p.y, p.z).to(p.x, p.y, p.z);
      for (int c = (int) Math.floor(p.z) - 1; c <= p.z; c++) {
        for (int b = (int) Math.floor(p.y) - 1; b <= p.y; b++) {
          for (int a = (int) Math.floor(p.x) - 1; a <= p.x; a++) {
            if (ExactOracle.touches(rest, a, b, c)) {
              touched.add(new int[] {level, a, b, c});
            }
          }
        }
      }
    }
    return touched;
  }

  private static boolean naiveMeets(
      ClearanceLevels levels, List<int[]> touched, int i, int j, int k) {
    for (int[] cell : touched) {
      int level = cell[0];
      boolean meets =
          level == 0
              ? cell[1] == i && cell[2] == j && cell[3] == k
              : isSolidBy(levels.grown(level), cell[1], cell[2], cell[3], i, j, k);
      if (meets) {
        return true;
      }
    }
    return false;
  }

  private static boolean naiveEncloses(
      MoverVerifier verifier, RigidTool tool, Clearance clearance, int i, int j, int k) {
    Body body = verifier.pair(0).levels.body;
    Vec3 p = body.grid().gridToWorld(new Vec3(i + 0.5, j + 0.5, k + 0.5), new Vec3());
    body.pose().transform(p, p);
    verifier.pose().inverseTransform(p, p);
    return clearance.growthMm() > 0 && tool.solid() != null && tool.solid().contains(p.x, p.y, p.z);
  }

  /** Whether a grown cell is solid if a voxel is: its distance is less than the growth. Exact. */
  private static boolean isSolidBy(GrownSolids grown, int x, int y, int z, int i, int j, int k) {
    BigDecimal growth = new BigDecimal(grown.growthMm());
    BigDecimal reach = growth.multiply(growth);
    BigDecimal square = squaredGap(grown, 0, x, i);
    if (square.compareTo(reach) >= 0) {
      return false;
    }
    square = square.add(squaredGap(grown, 1, y, j));
    return square.compareTo(reach) < 0
        && square.add(squaredGap(grown, 2, z, k)).compareTo(reach) < 0;
  }

  private static void moveTo(Pose pose, MoverVerifier verifier) {
    verifier.propose(pose);
    assertTrue(verifier.isFree(0, 0, true, new LegHits()), "what blocked the way is gone");
    verifier.commit();
  }

  /** Removes what is found until nothing is, and returns all of it. */
  private static Set<String> removeAll(
      BodyScene scene, MoverVerifier verifier, BlockingVoxels blocking, Pose device) {
    Set<String> all = new TreeSet<>();
    List<int[]> removed = new ArrayList<>();
    do {
      removed.clear();
      blocking.find(
          device,
          (body, i, j, k) -> {
            if (scene.body(body).bits().get(i, j, k)) {
              scene.body(body).bits().clear(i, j, k);
              removed.add(new int[] {body, i, j, k});
            }
            return true;
          });
      for (int[] voxel : removed) {
        all.add(voxel[0] + ":" + voxel[1] + "," + voxel[2] + "," + voxel[3]);
        IntBox box = new IntBox();
        box.include(voxel[1], voxel[2], voxel[3]);
        scene.body(voxel[0]).voxelsChanged(box);
      }
      verifier.takeEdits();
    } while (!removed.isEmpty());
    return all;
  }

  private static Set<String> naive(
      BodyScene scene, RigidTool tool, MoverVerifier verifier, Pose device) {
    Pose next = limited(scene, tool, verifier.pose(), device);
    Set<String> all = new TreeSet<>();
    for (int b = 0; b < scene.count(); b++) {
      for (int point = 0; point < tool.count(); point++) {
        addBlocking(b, verifier.pair(b), tool.point(point, new Vec3()), point, next, all);
      }
    }
    return all;
  }

  /**
   * Returns the device pose, or the part of the way on which no point moves more than two edges.
   */
  private static Pose limited(BodyScene scene, RigidTool tool, Pose pose, Pose device) {
    Vec3 displacement = new Vec3();
    Vec3 rotation = new Vec3();
    Quaternion scratch = new Quaternion();
    pose.differenceTo(device, displacement, rotation, scratch);
    double mostMm = displacement.length() + rotation.length() * tool.radiusMm();
    double reachMm = BlockingVoxels.REACH_EDGES * scene.shortestEdgeMm();
    double fraction = mostMm > reachMm ? reachMm / mostMm : 1;
    return pose.displace(displacement, rotation, fraction, scratch, new Pose());
  }

  private static void addBlocking(
      int b, BodyVerifier verifier, Vec3 point, int index, Pose next, Set<String> all) {
    ClearanceLevels levels = verifier.levels;
    int level = verifier.level(index);
    AffineMap cells = new AffineMap();
    Vec3 from = levels.toCells(verifier.from(), level, cells).transform(point, new Vec3());
    AffineMap to = levels.body.toolToGrid(next, new AffineMap());
    Vec3 end = levels.toCells(to, level, cells).transform(point, new Vec3());
    Ray leg = new Ray().from(from.x, from.y, from.z).to(end.x, end.y, end.z);
    BitCube cube = levels.cubes[level];
    for (int c = low(from.z, end.z); c <= high(from.z, end.z); c++) {
      for (int y = low(from.y, end.y); y <= high(from.y, end.y); y++) {
        for (int a = low(from.x, end.x); a <= high(from.x, end.x); a++) {
          if (cube.get(a, y, c) && ExactOracle.touches(leg, a, y, c)) {
            addSources(b, levels.body, level == 0 ? null : levels.grown(level), a, y, c, all);
          }
        }
      }
    }
  }

  private static int low(double p, double q) {
    return (int) Math.floor(Math.min(p, q)) - 1;
  }

  private static int high(double p, double q) {
    return (int) Math.floor(Math.max(p, q)) + 1;
  }

  private static void addSources(
      int b, Body body, GrownSolids grown, int x, int y, int z, Set<String> all) {
    if (grown == null) {
      all.add(b + ":" + x + "," + y + "," + z);
      return;
    }
    BitCube bits = body.bits();
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          if (bits.get(i, j, k) && isSolidBy(grown, x, y, z, i, j, k)) {
            all.add(b + ":" + i + "," + j + "," + k);
          }
        }
      }
    }
  }

  /** Returns the squared distance of a cell from a voxel along an axis, mm^2, without rounding. */
  private static BigDecimal squaredGap(GrownSolids grown, int axis, int cell, int voxel) {
    int parts = grown.parts(axis);
    int first = (voxel + grown.padVoxels()) * parts;
    int gap = Math.max(0, Math.max(first - (cell + 1), cell - (first + parts)));
    BigDecimal mm = new BigDecimal(grown.cellMm(axis)).multiply(BigDecimal.valueOf(gap));
    return mm.multiply(mm);
  }
}
