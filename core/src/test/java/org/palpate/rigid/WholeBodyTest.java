package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.body.BodyScene;
import org.palpate.body.GrownSolids;
import org.palpate.body.RandomSolids;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

class WholeBodyTest {
  private static final double MAX_STEP_MM = 8;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final ToolMotion motion = new ToolMotion();

  @Test
  void inModeBodyNoFrameOfAHostileSessionOverlaps() {
    int contacts = 0;
    for (int round = 0; round < 12; round++) {
      BodyScene scene = ToolScenes.clutter(random, 1 + round % 3);
      BitCube bits = RandomSolids.clutter(random, 8, 9, 7);
      RigidTool tool = ToolSampler.ofSegment(bits, VoxelGrid.ofUnitVoxels(8, 9, 7));
      OverlapJudge judge = new OverlapJudge(bits, tool);
      RigidSettings settings = RigidSettings.ofWholeBodies(MAX_STEP_MM, scene, tool);
      RigidSolver solver = new RigidSolver(scene, tool, settings);
      Pose start = new Pose();
      start.translation.set(200, 200, 200);
      assertTrue(solver.place(start, motion));
      HostilePoses device = new HostilePoses(random, 30);
      for (int frame = 0; frame < 250; frame++) {
        solver.follow(device.next(), motion);
        contacts += motion.contact() ? 1 : 0;
        for (int step = 1; step <= motion.steps(); step++) {
          boolean overlaps = judge.overlaps(scene, motion.pathPose(step));
          assertFalse(overlaps, "seed " + Seeds.seed() + " round " + round + " frame " + frame);
        }
      }
      assertTrue(judge.leastGapMm() > 0, "gap " + judge.leastGapMm());
    }
    assertTrue(contacts > 150, "frames with contact: " + contacts);
  }

  @Test
  void theJudgeSeesAnOverlapOfTheSmallestDepth() {
    BitCube dot = new BitCube(3, 3, 3);
    dot.set(1, 1, 1);
    BodyScene scene = new BodyScene(List.of(ToolScenes.unit("dot", dot)));
    BitCube one = new BitCube(1, 1, 1);
    one.set(0, 0, 0);
    RigidTool tool = ToolSampler.ofSegment(one, VoxelGrid.ofUnitVoxels(1, 1, 1));
    OverlapJudge judge = new OverlapJudge(one, tool);
    Pose pose = new Pose();
    pose.translation.set(2.5, 1.5, 1.5); // face to face
    assertFalse(judge.overlaps(scene, pose));
    pose.translation.x -= 1e-6;
    assertTrue(judge.overlaps(scene, pose));
    pose.rotation.setRotationVector(new Vec3(0, 0, Math.PI / 4));
    pose.translation.x = 2 + Math.sqrt(0.5) + 1e-6; // edge to face
    assertFalse(judge.overlaps(scene, pose));
    pose.translation.x -= 1e-5;
    assertTrue(judge.overlaps(scene, pose));
  }

  @Test
  void pointsAloneWouldOverlapSoTheClearanceIsNeeded() {
    BitCube slab = ToolScenes.block(30, 30, 10);
    BitCube bits = ToolScenes.block(6, 6, 6);
    BodyScene scene = new BodyScene(List.of(ToolScenes.unit("slab", slab)));
    RigidTool tool = ToolSampler.ofSegment(bits, VoxelGrid.ofUnitVoxels(6, 6, 6));
    assertTrue(pressed(scene, tool, bits, RigidSettings.of(MAX_STEP_MM, Clearance.POINTS)) < 0);
    RigidSettings whole = RigidSettings.ofWholeBodies(MAX_STEP_MM, scene, tool);
    assertTrue(pressed(scene, tool, bits, whole) > 0.1);
  }

  /** Pushes a tilted corner against the slab; returns the least gap. */
  private double pressed(BodyScene scene, RigidTool tool, BitCube bits, RigidSettings settings) {
    RigidSolver solver = new RigidSolver(scene, tool, settings);
    OverlapJudge judge = new OverlapJudge(bits, tool);
    Pose pose = new Pose();
    pose.rotation.setRotationVector(new Vec3(0.5, 0.4, 0));
    pose.translation.set(15, 15, 22);
    assertTrue(solver.place(pose, motion));
    for (int frame = 0; frame < 80; frame++) {
      pose.translation.z -= 0.2;
      solver.follow(pose, motion);
      judge.overlaps(scene, motion.pose());
    }
    return judge.leastGapMm();
  }

  @Test
  void aBodyInsideTheToolCountsAsOverlap() {
    BitCube dot = new BitCube(20, 20, 20);
    dot.set(10, 10, 10);
    BodyScene scene = new BodyScene(List.of(ToolScenes.unit("dot", dot)));
    for (int kind = 0; kind < 2; kind++) {
      BitCube cube = ToolScenes.block(9, 9, 9);
      RigidTool tool =
          kind == 0
              ? ToolSampler.ofSegment(cube, VoxelGrid.ofUnitVoxels(9, 9, 9))
              : ToolSampler.ofShape(RodShape.sphere(5), 0.8);
      RigidSettings settings = RigidSettings.ofWholeBodies(MAX_STEP_MM, scene, tool);
      RigidSolver solver = new RigidSolver(scene, tool, settings);
      Pose around = new Pose();
      around.translation.set(10.5, 10.5, 10.5);
      assertFalse(solver.place(around, motion));
      assertTrue(motion.freed());
      double moved = motion.pose().translation.sub(around.translation, new Vec3()).length();
      assertTrue(moved > 5 && moved < 12, "freed by " + moved);
    }
  }

  @Test
  void twoHalvesCutByASawFitToTheLastDigitAndSoDoUncutOnesByTheirPoints() {
    BitCube[] sawn = halves(true);
    BitCube[] uncut = halves(false);
    assertFits(uncut, false);
    assertFits(sawn, true);
  }

  private static void assertFits(BitCube[] halves, boolean whole) {
    VoxelGrid grid =
        VoxelGrid.ofUnitVoxels(halves[0].sizeX(), halves[0].sizeY(), halves[0].sizeZ());
    RigidTool tool = ToolSampler.ofSegment(halves[1], grid);
    BodyScene scene = new BodyScene(List.of(ToolScenes.unit("low", halves[0])));
    RigidSolver solver =
        new RigidSolver(
            scene,
            tool,
            whole
                ? RigidSettings.ofWholeBodies(MAX_STEP_MM, scene, tool)
                : RigidSettings.of(MAX_STEP_MM, Clearance.POINTS));
    ToolMotion motion = new ToolMotion();
    Pose home = new Pose();
    tool.referenceMm(home.translation);
    Pose device = new Pose();
    Quaternion scratch = new Quaternion();
    for (int frame = 0; frame <= 300; frame++) {
      double left = Math.max(0, 1 - frame / 200.0);
      Vec3 off = new Vec3(3 * left, -2 * left, 14 * left);
      home.displace(off, new Vec3(0.1 * left, -0.2 * left, 0.25 * left), 1, scratch, device);
      if (frame == 0) {
        assertTrue(solver.place(device, motion));
      }
      solver.follow(device, motion);
    }
    assertEquals(0, home.translation.sub(motion.pose().translation, new Vec3()).length(), 0.01);
    assertEquals(1, Math.abs(motion.pose().rotation.w), 1e-8);
  }

  /** Returns a ball in two halves, cut along a wavy face, with a kerf of a voxel or without. */
  private static BitCube[] halves(boolean sawn) {
    BitCube low = new BitCube(40, 40, 40);
    BitCube high = new BitCube(40, 40, 40);
    for (int n = 0; n < 64_000; n++) {
      int i = n % 40;
      int j = n / 40 % 40;
      int k = n / 1600;
      double radius =
          Math.sqrt((i - 19.5) * (i - 19.5) + (j - 19.5) * (j - 19.5) + (k - 19.5) * (k - 19.5));
      double cut = 20 + 2 * Math.sin(0.5 * i) * Math.cos(0.4 * j + 0.1 * i);
      if (radius < 16) {
        (k + 0.5 < cut ? low : high).set(i, j, k);
      }
    }
    if (sawn) {
      GrownSolids saw = new GrownSolids(low, new GridMetric(1, 1, 1), 1, 1);
      for (int n = 0; n < 64_000; n++) {
        if (saw.cells().get(n % 40 + 1, n / 40 % 40 + 1, n / 1600 + 1)) {
          high.clear(n % 40, n / 40 % 40, n / 1600);
        }
      }
    }
    return new BitCube[] {low, high};
  }

  @Test
  void aPegGoesIntoAHoleWithAPlayOfHalfAVoxel() {
    BitCube block = new BitCube(48, 48, 48);
    for (int n = 0; n < 48 * 48 * 30; n++) {
      int i = n % 48;
      int j = n / 48 % 48;
      if (Math.hypot(i + 0.5 - 23.7, j + 0.5 - 24.2) > 8.4) {
        block.set(i, j, n / 2304 + 4);
      }
    }
    BodyScene scene = new BodyScene(List.of(ToolScenes.unit("block", block)));
    BitCube peg = new BitCube(14, 14, 36);
    for (int n = 0; n < 14 * 14 * 36; n++) {
      if (Math.hypot(n % 14 + 0.5 - 7, n / 14 % 14 + 0.5 - 7) < 6.2) {
        peg.set(n % 14, n / 14 % 14, n / 196);
      }
    }
    RigidTool tool = ToolSampler.ofSegment(peg, VoxelGrid.ofUnitVoxels(14, 14, 36));
    for (int seed = 0; seed < 4; seed++) {
      RigidSettings settings = RigidSettings.ofWholeBodies(MAX_STEP_MM, scene, tool);
      RigidSolver solver = new RigidSolver(scene, tool, settings);
      Pose device = new Pose();
      double height = 60;
      for (int frame = 0; frame < 450; frame++) {
        height = Math.max(30, height - 0.1);
        double wobble = frame < 400 ? 1 : 0;
        device.translation.set(
            23.7 + wobble * Math.sin(0.05 * frame + seed), 24.2 + wobble * 0.7, height);
        device.rotation.setRotationVector(
            new Vec3(0.04 * wobble * Math.sin(0.03 * frame), 0.05 * wobble * Math.cos(seed), 0));
        if (frame == 0) {
          assertTrue(solver.place(device, motion));
        }
        solver.follow(device, motion);
      }
      assertEquals(30, motion.pose().translation.z, 0.5, "seed " + seed);
    }
  }
}
