package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class RigidSolverTest {
  private static final double MAX_STEP_MM = 8;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final ToolMotion motion = new ToolMotion();

  @Test
  void noLegOfAMillionTouchesASolidWhateverTheDeviceDoes() {
    long legs = 0;
    for (int round = 0; legs < 1_000_000; round++) {
      BodyScene scene = ToolScenes.clutter(random, 1 + round % 3);
      RigidTool tool = ToolScenes.tool(random);
      boolean whole = ToolScenes.hasCoveredSurface(tool) && round % 2 == 1;
      RigidSolver solver = solver(scene, tool, whole);
      solver.place(RandomGeometry.pose(random, 30), motion);
      ToolLegJudge judge = new ToolLegJudge(scene, tool);
      assertNull(judge.begin(motion));
      HostilePoses device = new HostilePoses(random, 40);
      for (int frame = 0; frame < 300; frame++) {
        solver.follow(device.next(), motion);
        String where = "seed " + Seeds.seed() + " round " + round + " frame " + frame;
        assertNull(judge.fault(motion), where);
        assertTrue(motion.pathMm() <= MAX_STEP_MM * (1 + 1e-9), where + " " + motion.pathMm());
      }
      legs += judge.legs();
    }
  }

  private static RigidSolver solver(BodyScene scene, RigidTool tool, boolean whole) {
    return new RigidSolver(
        scene,
        tool,
        whole
            ? RigidSettings.ofWholeBodies(MAX_STEP_MM, scene, tool)
            : RigidSettings.of(MAX_STEP_MM, Clearance.POINTS));
  }

  @Test
  void aToolRefusesToGoOnAfterABodyMoved() {
    BodyScene scene = ToolScenes.clutter(random, 1);
    RigidSolver solver = solver(scene, ToolSampler.point(), false);
    Pose away = new Pose();
    away.translation.set(300, 0, 0);
    solver.place(away, motion);
    Pose shifted = new Pose().set(scene.body(0).pose());
    shifted.translation.x += 290;
    scene.body(0).setPose(shifted);
    assertThrows(IllegalStateException.class, () -> solver.follow(away, motion));
    solver.place(away, motion);
    solver.follow(away, motion);
  }

  @Test
  void aToolIsNotPlacedAtAPoseThatIsNotFinite() {
    RigidSolver solver = solver(ToolScenes.clutter(random, 1), ToolSampler.point(), false);
    Pose pose = new Pose();
    pose.translation.x = Double.NaN;
    assertThrows(IllegalArgumentException.class, () -> solver.place(pose, motion));
  }

  @Test
  void aPathWithoutLimitLeadsStraightToAVisibleDevice() {
    RigidSolver solver =
        new RigidSolver(
            ToolScenes.phantom("plane:32"),
            ToolSampler.point(),
            RigidSettings.of(Double.POSITIVE_INFINITY, Clearance.POINTS));
    Pose start = new Pose();
    start.translation.set(16, 16, 100);
    Pose device = new Pose();
    device.translation.set(400, 16, 200);
    solver.place(start, motion);
    solver.follow(device, motion);
    assertTrue(motion.pose().sameBits(device), "pose=" + motion.pose());
  }

  @Test
  void theJudgeCatchesABrokenChainAndALegThroughASolid() {
    BodyScene scene = ToolScenes.phantom("plane:32");
    RigidTool tool = ToolSampler.ofShape(RodShape.sphere(2), 0.7);
    RigidSolver solver = solver(scene, tool, false);
    Pose pose = new Pose();
    pose.translation.set(16, 16, 40);
    assertTrue(solver.place(pose, motion));
    ToolLegJudge judge = new ToolLegJudge(scene, tool);
    assertNull(judge.begin(motion));
    pose.translation.z = 39;
    solver.follow(pose, motion);
    assertEquals(1, motion.steps());
    assertNull(judge.fault(motion));
    motion.rest();
    motion.path[0].translation.z = Math.nextUp(39.0);
    assertTrue(judge.fault(motion).contains("starts at"));
    motion.path[0].translation.z = 39;
    pose.translation.z = 4;
    motion.add(pose, 0);
    assertTrue(judge.fault(motion).contains("step 0"));
  }

  @Test
  void aToolComesToRestBitForBitSoonAfterTheDevice() {
    for (int round = 0; round < 30; round++) {
      BodyScene scene = ToolScenes.clutter(random, 1 + round % 2);
      RigidTool tool = ToolScenes.tool(random);
      RigidSolver solver = solver(scene, tool, false);
      solver.place(RandomGeometry.pose(random, 30), motion);
      HostilePoses device = new HostilePoses(random, 25);
      for (int frame = 0; frame < 60; frame++) {
        solver.follow(device.next(), motion);
      }
      Pose resting = new Pose().set(device.lastPose());
      int last = 0;
      Pose before = new Pose();
      for (int frame = 0; frame < 300; frame++) {
        before.set(motion.pose());
        solver.follow(resting, motion);
        last = before.sameBits(motion.pose()) ? last : frame;
      }
      assertTrue(last < 50, "round " + round + ": rests after " + last + " frames");
    }
  }

  @Test
  void reachesAFreeDevicePoseExactly() {
    BodyScene scene = ToolScenes.phantom("sphere:32");
    RigidTool tool = ToolSampler.ofShape(RodShape.capsule(2, 6), 0.7);
    RigidSolver solver = solver(scene, tool, true);
    Pose pose = new Pose();
    pose.translation.set(60, 60, 60);
    solver.place(pose, motion);
    Pose goal = RandomGeometry.pose(random, 3);
    goal.translation.add(new Vec3(55, 50, 45), goal.translation);
    for (int frame = 0; frame < 10; frame++) {
      solver.follow(goal, motion);
    }
    assertEquals(0, goal.translation.sub(motion.pose().translation, new Vec3()).length());
    assertEquals(1, Math.abs(goal.rotation.dot(motion.pose().rotation)), 1e-15);
    assertFalse(motion.contact());
  }

  @Test
  void aPressedToolStandsOffAPlaneAlongItsNormal() {
    BodyScene scene = ToolScenes.phantom("plane:96");
    Vec3 n = new Vec3(0.231, 0.377, 0.894); // of the phantom
    n.mul(1 / n.length(), n);
    RigidTool tool = ToolSampler.ofShape(RodShape.sphere(6), 0.7);
    for (int whole = 0; whole < 2; whole++) {
      RigidSolver solver = solver(scene, tool, whole == 1);
      Pose pose = new Pose();
      Vec3 middle = new Vec3(48, 48, 48);
      n.mul(20, pose.translation).add(middle, pose.translation);
      assertTrue(solver.place(pose, motion));
      for (double h = 20; h > 2; h -= 0.2) {
        n.mul(h, pose.translation).add(middle, pose.translation);
        solver.follow(pose, motion);
      }
      for (int frame = 0; frame < 60; frame++) {
        solver.follow(pose, motion);
      }
      Vec3 off = motion.pose().translation.sub(pose.translation, new Vec3());
      double cosine = off.dot(n) / off.length();
      assertTrue(motion.contact());
      assertTrue(off.length() > 4 && off.length() < 8, "stands off by " + off.length());
      assertTrue(Math.toDegrees(Math.acos(Math.min(1, cosine))) < 2, off + " is not normal");
    }
  }

  @Test
  void aToolThatVoxelsBuryIsSetFreeWithItsOrientationKept() {
    for (int whole = 0; whole < 2; whole++) {
      BitCube bits = new BitCube(40, 40, 40);
      bits.set(0, 0, 0);
      Body body = ToolScenes.unit("body", bits);
      BodyScene scene = new BodyScene(List.of(body));
      RigidTool tool = ToolSampler.ofShape(RodShape.sphere(4), 0.7);
      RigidSolver solver = solver(scene, tool, whole == 1);
      ToolLegJudge judge = new ToolLegJudge(scene, tool);
      Pose pose = RandomGeometry.pose(random, 1);
      pose.translation.set(20, 20, 20);
      assertTrue(solver.place(pose, motion));
      assertNull(judge.begin(motion));
      solver.follow(pose, motion);
      Pose before = new Pose().set(motion.pose());
      IntBox box = new IntBox();
      box.include(16, 14, 14);
      box.include(26, 26, 26);
      for (int n = 0; n < 11 * 13 * 13; n++) {
        bits.set(16 + n % 11, 14 + n / 11 % 13, 14 + n / 143);
      }
      body.voxelsChanged(box);
      solver.follow(pose, motion);
      assertTrue(motion.freed());
      assertNull(judge.fault(motion));
      Vec3 moved = motion.pathPose(0).translation.sub(pose.translation, new Vec3());
      assertTrue(moved.length() < 13, "freed by " + moved);
      assertTrue(motion.pathPose(0).rotation.sameBits(before.rotation));
      solver.follow(pose, motion);
      assertFalse(motion.freed());
      assertNull(judge.fault(motion));
    }
  }

  @Test
  void removedVoxelsLetAPressedToolGoOn() {
    BitCube bits = new BitCube(30, 30, 12);
    for (int n = 0; n < 900; n++) {
      bits.set(n % 30, n / 30, 5);
    }
    Body body = ToolScenes.unit("wall", bits);
    BodyScene scene = new BodyScene(List.of(body));
    RigidTool tool = ToolSampler.ofShape(RodShape.sphere(3), 0.7);
    RigidSolver solver = solver(scene, tool, false);
    Pose pose = new Pose();
    pose.translation.set(15, 15, 12);
    assertTrue(solver.place(pose, motion));
    pose.translation.z = 4;
    for (int frame = 0; frame < 60; frame++) {
      solver.follow(pose, motion);
    }
    assertTrue(motion.pose().translation.z > 8.9, "held by a wall one voxel thick");
    IntBox box = new IntBox();
    for (int n = 0; n < 900; n++) {
      bits.clear(n % 30, n / 30, 5);
      box.include(n % 30, n / 30, 5);
    }
    body.voxelsChanged(box);
    for (int frame = 0; frame < 20; frame++) {
      solver.follow(pose, motion);
    }
    assertEquals(4, motion.pose().translation.z);
  }

  @Test
  void aWallOneVoxelThickHoldsFromBothSides() {
    BitCube bits = new BitCube(24, 24, 24);
    for (int n = 0; n < 576; n++) {
      bits.set(n % 24, n / 24, 12);
    }
    BodyScene scene = new BodyScene(List.of(ToolScenes.unit("wall", bits)));
    RigidTool tool = ToolSampler.ofShape(new BoxShape(6, 6, 2), 0.7);
    for (int side = -1; side <= 1; side += 2) {
      RigidSolver solver = solver(scene, tool, false);
      ToolLegJudge judge = new ToolLegJudge(scene, tool);
      Pose pose = new Pose();
      pose.translation.set(12.3, 11.8, 12.5 + side * 6);
      assertTrue(solver.place(pose, motion));
      assertNull(judge.begin(motion));
      pose.translation.z = 12.5 - side * 4;
      for (int frame = 0; frame < 40; frame++) {
        pose.translation.x += 0.05;
        solver.follow(pose, motion);
        assertNull(judge.fault(motion));
      }
      double height = side * (motion.pose().translation.z - 12.5);
      assertTrue(height > 1.5 && height < 3.2, "height " + height);
    }
  }

  @Test
  void skipsChangeNoBit() {
    for (int round = 0; round < 6; round++) {
      BodyScene scene = ToolScenes.clutter(random, 1 + round % 2);
      RigidTool tool = ToolScenes.tool(random);
      RigidSettings with = RigidSettings.of(MAX_STEP_MM, Clearance.POINTS);
      RigidSettings without =
          new RigidSettings(MAX_STEP_MM, with.clearances(), with.greys(), false);
      RigidSolver quick = new RigidSolver(scene, tool, with);
      RigidSolver slow = new RigidSolver(scene, tool, without);
      ToolMotion slowMotion = new ToolMotion();
      Pose start = RandomGeometry.pose(random, 30);
      quick.place(start, motion);
      slow.place(start, slowMotion);
      HostilePoses device = new HostilePoses(random, 25);
      for (int frame = 0; frame < 200; frame++) {
        Pose pose = device.next();
        quick.follow(pose, motion);
        slow.follow(pose, slowMotion);
        assertTrue(motion.pose().sameBits(slowMotion.pose()), "frame " + frame);
        assertEquals(slow.work(), quick.work());
      }
    }
  }

  @Test
  void aDeviceThatNeverReportedAPoseLeavesTheToolWhereItIs() {
    BodyScene scene = ToolScenes.phantom("sphere:32");
    RigidSolver solver = solver(scene, ToolSampler.point(), false);
    Pose pose = new Pose();
    pose.translation.set(2, 2, 2);
    solver.place(pose, motion);
    Pose none = new Pose();
    none.rotation.set(new Quaternion(0, 0, 0, 0));
    solver.follow(none, motion);
    assertTrue(motion.pose().sameBits(pose));
    assertEquals(0, motion.steps());
  }
}
