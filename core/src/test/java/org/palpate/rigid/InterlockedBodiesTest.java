package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.RoughBlocks;
import org.palpate.volume.VoxelGrid;

/** Two blocks whose rough faces fit each other column by column; a hand leads one home. */
class InterlockedBodiesTest {
  private static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(14, 14, 14);

  /** Rough faces on which the smooth surface alone stops the body. */
  private static final long[] SEEDS = {7, 9, 16, 23};

  private static final double ARRIVED_MM = 0.1;
  private static final double MARGIN_MM = -0.5;
  private static final double FROM_MM = 6;
  private static final int APPROACH_FRAMES = 100;
  private static final int SETTLING_FRAMES = 200;

  /** The error of the hand on the way, and the frames in which it corrects it at home. */
  private static final Vec3 SKEW_MM = new Vec3(0.1, -0.07, 0);

  private static final Vec3 SKEW_RAD = new Vec3(0.004, -0.003, 0.004);
  private static final double SKEW_FRAMES = 50;

  /** A hand is never at rest. */
  private static final double TREMOR_MM = 0.01;

  private final Quaternion scratch = new Quaternion();

  @Test
  void aBodyInHandComesHomeBetweenTeethAlongFacesOfVoxels() {
    for (long seed : SEEDS) {
      double leftMm = residualMm(seed, true);
      assertTrue(leftMm < ARRIVED_MM, "seed=" + seed + " leftMm=" + leftMm);
    }
  }

  @Test
  void theSmoothSurfaceAloneStopsItBesideItsPlace() {
    for (long seed : SEEDS) {
      double leftMm = residualMm(seed, false);
      assertTrue(leftMm > 1, "seed=" + seed + " leftMm=" + leftMm);
    }
  }

  /** Returns how far from home the body stops that a hand leads straight down, a little askew. */
  private double residualMm(long seed, boolean leavesSurface) {
    BodyScene scene = RoughBlocks.scene(new SplittableRandom(seed), GRID, 5, 8);
    MovableShapes shapes = MovableShapes.ofWholeBodies(scene, MARGIN_MM);
    RigidSettings settings = RigidSettings.of(8, Clearance.POINTS);
    RigidSolver tool =
        new RigidSolver(new RigidScene(scene, ToolSampler.point(), shapes, settings));
    ToolMotion motion = tool.newMotion();
    scene.body(1).setPose(Pose.at(0, 0, FROM_MM));
    tool.place(Pose.at(-1000, 0, 0), motion);
    RigidSolver hand = tool.ofBody(1, leavesSurface);
    hand.takeOver(motion);
    Pose home = new Pose();
    hand.shape().referenceMm(home.translation);
    Pose device = new Pose();
    for (int n = 0; n < APPROACH_FRAMES + SETTLING_FRAMES; n++) {
      double left = Math.max(0, 1 - (double) n / APPROACH_FRAMES);
      double skew = Math.max(0, Math.min(1, 1 - (n - APPROACH_FRAMES) / SKEW_FRAMES));
      home.displace(SKEW_MM, SKEW_RAD, skew, scratch, device);
      device.translation.z += FROM_MM * left + TREMOR_MM * Math.sin(n);
      hand.follow(device, motion);
    }
    return hand.shape().metric().distance(motion.pose(), home);
  }
}
