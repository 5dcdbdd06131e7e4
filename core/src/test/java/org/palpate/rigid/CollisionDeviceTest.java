package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.collision.CollisionDevice;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

/** Tests that a device which judges legs in batches changes no bit of what a tool does. */
class CollisionDeviceTest {
  private static final double MAX_STEP_MM = 8;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final ToolMotion motion = new ToolMotion();

  @Test
  void posesAndWorkAreThoseOfTheCpuWhateverIsEdited() {
    long batches = 0;
    long motions = 0;
    for (int round = 0; round < 16; round++) {
      BodyScene scene = ToolScenes.clutter(random, 1 + round % 2);
      RigidTool tool = ToolScenes.tool(random);
      boolean whole = ToolScenes.hasCoveredSurface(tool) && round % 3 != 0;
      CopyingDevice device = new CopyingDevice(random.split(), 0, false);
      RigidSettings plain =
          whole
              ? RigidSettings.ofWholeBodies(MAX_STEP_MM, scene, tool)
              : RigidSettings.of(MAX_STEP_MM, Clearance.POINTS);
      compare(scene, tool, plain, on(device, plain, round % 4 != 0));
      batches += device.batches();
      motions += device.motions();
    }
    assertTrue(batches > 5_000, "batches " + batches);
    assertTrue(motions > 1.2 * batches, "motions " + motions + " in batches " + batches);
  }

  private static RigidSettings on(CollisionDevice device, RigidSettings plain, boolean skips) {
    return new RigidSettings(plain.maxStepMm(), plain.clearances(), plain.greys(), skips, device);
  }

  private void compare(BodyScene scene, RigidTool tool, RigidSettings cpu, RigidSettings device) {
    RigidSolver expected = new RigidSolver(scene, tool, cpu);
    RigidSolver solver = new RigidSolver(scene, tool, device);
    ToolMotion expectedMotion = new ToolMotion();
    Pose start = RandomGeometry.pose(random, 30);
    assertEquals(expected.place(start, expectedMotion), solver.place(start, motion));
    HostilePoses hand = new HostilePoses(random, 25);
    for (int frame = 0; frame < 200; frame++) {
      if (frame % 5 == 0) {
        edit(scene.body(frame % scene.count()));
      }
      Pose pose = hand.next();
      expected.follow(pose, expectedMotion);
      solver.follow(pose, motion);
      String where = "seed " + Seeds.seed() + " frame " + frame;
      assertTrue(motion.pose().sameBits(expectedMotion.pose()), where);
      assertEquals(expected.work(), solver.work(), where);
      assertEquals(expectedMotion.steps(), motion.steps(), where);
    }
  }

  /** Fills or clears some voxels about a random one. */
  private void edit(Body body) {
    BitCube bits = body.bits();
    IntBox box = new IntBox();
    boolean fill = random.nextBoolean();
    int i = random.nextInt(bits.sizeX() - 2);
    int j = random.nextInt(bits.sizeY() - 2);
    int k = random.nextInt(bits.sizeZ() - 2);
    for (int n = 0; n < 27; n++) {
      box.include(i + n % 3, j + n / 3 % 3, k + n / 9);
      if (fill) {
        bits.set(i + n % 3, j + n / 3 % 3, k + n / 9);
      } else {
        bits.clear(i + n % 3, j + n / 3 % 3, k + n / 9);
      }
    }
    body.voxelsChanged(box);
  }

  @Test
  void aDeviceThatCallsEveryLegFreeWouldBeFound() {
    BodyScene scene = ToolScenes.phantom("sphere:32");
    RigidTool tool = ToolSampler.ofShape(new BoxShape(4, 4, 4), 0.7);
    RigidSettings plain = RigidSettings.of(MAX_STEP_MM, Clearance.POINTS);
    RigidSettings lying = on(new CopyingDevice(random, 0, true), plain, true);
    RigidSolver solver = new RigidSolver(scene, tool, lying);
    ToolLegJudge judge = new ToolLegJudge(scene, tool);
    Pose pose = new Pose();
    pose.translation.set(16, 16, -8);
    assertTrue(solver.place(pose, motion));
    judge.begin(motion);
    boolean found = false;
    for (int frame = 0; frame < 60; frame++) {
      pose.translation.z += 0.4;
      solver.follow(pose, motion);
      found |= judge.fault(motion) != null;
    }
    assertTrue(found);
  }

  @Test
  void aDeviceIsNotAskedForFewLegs() {
    BodyScene scene = ToolScenes.phantom("sphere:32");
    RigidTool tool = ToolSampler.ofShape(new BoxShape(4, 4, 4), 0.7);
    CopyingDevice device = new CopyingDevice(random, tool.count() + 1, false);
    RigidSettings plain = RigidSettings.of(MAX_STEP_MM, Clearance.POINTS);
    compare(scene, tool, plain, on(device, plain, true));
    assertEquals(0, device.batches());
  }

  @Test
  void voxelsThatTheDeviceHasNotSeenYetBlockLegs() {
    BitCube bits = new BitCube(24, 24, 24);
    Body body = ToolScenes.unit("wall", bits);
    bits.set(1, 1, 1);
    RigidTool tool = ToolSampler.ofShape(new BoxShape(4, 4, 2), 0.7);
    RigidSettings plain = RigidSettings.of(MAX_STEP_MM, Clearance.POINTS);
    BodyScene scene = new BodyScene(List.of(body));
    RigidSettings settings = on(new CopyingDevice(random, 0, false), plain, false);
    RigidScene rigid = new RigidScene(scene, tool, MovableShapes.none(scene), settings);
    MoverVerifier verifier = rigid.verifier(rigid.toolIndex());
    Pose pose = new Pose();
    pose.translation.set(12, 12, 6);
    assertTrue(verifier.place(pose, true));
    pose.translation.z = 14;
    verifier.propose(pose);
    assertTrue(verifier.isFree(0, 0, true, new LegHits()));
    IntBox box = new IntBox();
    for (int n = 0; n < 24 * 24; n++) {
      bits.set(n % 24, n / 24, 10);
      box.include(n % 24, n / 24, 10);
    }
    body.voxelsChanged(box);
    assertFalse(verifier.isFree(0, 0, true, new LegHits()));
  }
}
