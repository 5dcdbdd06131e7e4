package org.palpate.benchmarks.moving;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.RigidScene;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.ToolMotion;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.RoughBlocks;
import org.palpate.volume.VoxelGrid;

/**
 * A trembling hand presses a block into another one whose rough face fits it. There the block also
 * takes steps along faces of voxels while the device moves. Every leg is judged exactly.
 */
class InterlockedLegsTest {
  private static final int EDGE = 8;
  private static final int SCENES = 4;
  private static final int FRAMES = 120;
  private static final int APPROACH_FRAMES = 60;
  private static final double FROM_MM = 6;
  private static final double TREMOR_MM = 0.05;

  /** The device does not quite lead to the place of the block, but turned and too low. */
  private static final Vec3 SKEW_MM = new Vec3(0.2, -0.15, -1);

  private static final Vec3 SKEW_RAD = new Vec3(0.02, -0.015, 0.02);

  private final RigidTool point = ToolSampler.point();
  private final Quaternion scratch = new Quaternion();

  @Test
  void noLegOfABodyThatMovesAlongFacesOfVoxelsTouchesASolid() {
    int parted = 0;
    for (long seed = 1; seed <= SCENES; seed++) {
      Pose alongFaces = lastPose(seed, true);
      parted += alongFaces.sameBits(lastPose(seed, false)) ? 0 : 1;
    }
    assertTrue(parted > SCENES / 2, "the block took steps along faces in " + parted + " scenes");
  }

  /** Leads the block home, judges all its legs, and returns where it ends. */
  private Pose lastPose(long seed, boolean leavesSurface) {
    SplittableRandom random = new SplittableRandom(seed);
    BodyScene scene = RoughBlocks.scene(random, VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE), 3, 5);
    MovableShapes shapes = MovableShapes.ofPoints(scene);
    RigidSettings settings = RigidSettings.of(8, Clearance.POINTS);
    RigidSolver tool = new RigidSolver(new RigidScene(scene, point, shapes, settings));
    ToolMotion motion = tool.newMotion();
    scene.body(1).setPose(Pose.at(0, 0, FROM_MM));
    tool.place(Pose.at(-1000, 0, 0), motion);
    SceneLegJudge judge = new SceneLegJudge(scene, point, shapes);
    judge.begin(motion);
    RigidSolver hand = tool.ofBody(1, leavesSurface);
    hand.takeOver(motion);
    judge.take(1, motion);
    Pose home = new Pose();
    hand.shape().referenceMm(home.translation);
    Pose device = new Pose();
    for (int n = 0; n < FRAMES; n++) {
      double left = Math.max(0, 1 - (double) n / APPROACH_FRAMES);
      home.displace(SKEW_MM, SKEW_RAD, 1, scratch, device);
      device.translation.x += TREMOR_MM * random.nextDouble(-1, 1);
      device.translation.z += FROM_MM * left + TREMOR_MM * random.nextDouble(-1, 1);
      hand.follow(device, motion);
      judge.judge(motion);
    }
    assertTrue(judge.legs() > FRAMES * EDGE * EDGE, "legs " + judge.legs());
    assertEquals(0, judge.touching(), "seed=" + seed);
    assertEquals(0, judge.broken(), "seed=" + seed);
    return new Pose().set(motion.pose());
  }
}
