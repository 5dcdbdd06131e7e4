package org.palpate.benchmarks.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.BitCube;

/** Watches a point that is held in a cavity of one voxel, and one that nothing holds. */
class ToolWatchTest {
  private static final long SEED = 4;

  private final RigidTool point = ToolSampler.point();
  private final ToolWatch watch = new ToolWatch(SEED);

  /** Returns a cube of solids around an empty voxel, from which a tunnel leads out along x. */
  private static BodyScene cavity(boolean hasTunnel) {
    BitCube bits = new BitCube(7, 7, 7);
    for (int n = 0; n < 343; n++) {
      boolean isEmpty = n == 171 || (hasTunnel && n > 171 && n <= 174);
      if (!isEmpty) {
        bits.set(n % 7, n / 7 % 7, n / 49);
      }
    }
    return SurfaceScene.scene(bits);
  }

  /** Returns a run whose tool was placed and has not moved. */
  private ToolRun placed(BodyScene scene) {
    ToolRun run = new ToolRun(scene, point, ToolClearance.POINTS);
    run.start(Pose.at(3.5, 3.5, 3.5));
    return run;
  }

  private double figure(String name) {
    return watch.figures("c").stream()
        .filter(figure -> figure.name().equals(name))
        .findFirst()
        .orElseThrow()
        .value();
  }

  private void watch(BodyScene scene, ToolRun run, Pose device, int frames) {
    KeepOut keepOut = new KeepOut(scene, point, Clearance.POINTS);
    for (int frame = 0; frame < frames; frame++) {
      watch.watch(run, keepOut, device);
    }
  }

  /** Watches a tool that followed the device as far as it could. */
  private void watchAtRest(BodyScene scene, Pose device, int frames) {
    ToolRun run = placed(scene);
    run.framesToRest(device);
    watch(scene, run, device, frames);
  }

  @Test
  void aToolInAClosedCavityIsStuckWithoutAWayOut() {
    watchAtRest(cavity(false), Pose.at(5.5, 3.5, 3.5), 10);
    assertEquals(100, figure("stuck frames"));
    assertEquals(2, figure("stuck frames searched"), "one in five is searched");
    assertEquals(0, figure("searched frames with a way out"));
  }

  @Test
  void aToolAtAnOpenTunnelHasAWayOut() {
    BodyScene scene = cavity(true);
    watch(scene, placed(scene), Pose.at(5.5, 3.5, 3.5), 6);
    assertEquals(2, figure("stuck frames searched"));
    assertEquals(100, figure("searched frames with a way out"));
  }

  @Test
  void aTunnelThatLeadsAwayFromTheDeviceIsNoWayOut() {
    watchAtRest(cavity(true), Pose.at(2, 3.5, 3.5), 5);
    assertEquals(1, figure("stuck frames searched"));
    assertEquals(0, figure("searched frames with a way out"));
  }

  @Test
  void aToolNearTheDeviceIsNotStuck() {
    watchAtRest(cavity(false), Pose.at(4.3, 3.5, 3.5), 10);
    assertEquals(0, figure("stuck frames"));
    assertEquals(0, figure("stuck frames searched"));
  }

  @Test
  void aToolThatMovesIsNotStuck() {
    BodyScene scene = SurfaceScene.scene(new BitCube(7, 7, 7));
    KeepOut keepOut = new KeepOut(scene, point, Clearance.POINTS);
    ToolRun run = placed(scene);
    Pose far = Pose.at(30, 3.5, 3.5);
    run.follow(far);
    assertTrue(run.motion.steps() > 0 && run.behindMm(far) > 0.5, "it is still on its way");
    watch.watch(run, keepOut, far);
    assertEquals(0, figure("stuck frames"));
  }

  @Test
  void theLongestWayToRestCounts() {
    ToolRun run = placed(SurfaceScene.scene(new BitCube(7, 7, 7)));
    watch.rest(run, Pose.at(30, 3.5, 3.5));
    double most = figure("frames to rest, most");
    assertTrue(most >= 26.5 / ToolClearance.MAX_STEP_MM, "frames " + most);
    watch.rest(run, Pose.at(30, 3.5, 3.5));
    assertEquals(most, figure("frames to rest, most"), "it rests already");
  }
}
