package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.body.RandomSolids;
import org.palpate.carve.CarveSettings;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.edit.BrushEdit;
import org.palpate.edit.Edit;
import org.palpate.edit.EditQueue;
import org.palpate.edit.HistoryEdit;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FrameOutcome;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.FrameStatistics;
import org.palpate.frame.ToolFrame;
import org.palpate.frame.ToolFramePublisher;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.testing.ScriptedDevice;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** Attacks whole frames of rigid tools and judges every leg, force and torque. */
class ToolFrameLegsTest {
  private static final int EDGE = 28;
  private static final int FRAMES = 1500;
  private static final double MAX_NEWTON = 4;
  private static final double MAX_NEWTON_MM = 60;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private long nowNanos;
  private long deviceNanos;
  private long freed;

  @Test
  void noLegTouchesASolidAndNoForceIsOutOfBoundsWhateverDeviceClockAndEditsDo() {
    long legs = 0;
    for (int round = 0; round < 12; round++) {
      legs += attack(round);
    }
    assertTrue(legs > 100_000, "legs " + legs);
    assertTrue(freed > 12, "edits came to the tool: freed " + freed);
  }

  private long attack(int round) {
    BitCube bits = RandomSolids.clutter(random, EDGE, EDGE, EDGE);
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE);
    Body body = new Body("clutter", bits, grid, Mobility.FIXED);
    BodyScene scene = new BodyScene(List.of(body));
    RigidTool tool = ToolScenes.tool(random);
    RigidSettings settings =
        ToolScenes.hasCoveredSurface(tool) && round % 2 == 0
            ? RigidSettings.ofWholeBodies(6, scene, tool)
            : RigidSettings.of(6, Clearance.POINTS);
    EditQueue edits = EditQueue.ofBodies(scene.grids());
    HostilePoses hand = new HostilePoses(random, 0.7 * EDGE);
    ScriptedDevice device = new ScriptedDevice((read, state) -> read(hand, state));
    ToolFrame frame =
        new ToolFrame(
            device,
            scene,
            new RigidSolver(scene, tool, settings),
            RigidCoupling.of(tool, 0.5),
            new FrameSettings(
                ForceSettings.of(0.5, 0),
                MAX_NEWTON,
                1,
                50_000_000,
                20_000_000,
                2048,
                MAX_NEWTON_MM,
                15),
            edits,
            ToolFramePublisher.NONE);
    if (round % 3 != 0) {
      frame.carve(CarveSettings.ofRate(round % 3 == 1 ? 1 : 1000));
    }
    ToolLegJudge judge = new ToolLegJudge(scene, tool);
    boolean begun = false;
    for (int n = 0; n < FRAMES; n++) {
      if (random.nextInt(20) == 0) {
        edits.offer(edit(frame.motion().pose()));
      }
      nowNanos += random.nextInt(300) == 0 ? 40_000_000 : 1_000_000;
      assertEquals(FrameOutcome.RUNNING, frame.run(nowNanos));
      String where = "seed " + Seeds.seed() + " round " + round + " frame " + n;
      if (!begun && frame.followed()) {
        begun = true;
        assertNull(judge.beginOfFrame(frame.motion()), where);
      }
      if (begun && frame.followed()) {
        assertNull(judge.fault(frame.motion()), where);
      }
      assertTrue(device.lastForce().length() <= MAX_NEWTON, where);
      assertTrue(device.lastTorque().length() <= MAX_NEWTON_MM, where);
    }
    frame.release();
    assertEquals(0, device.lastForce().length());
    assertEquals(0, device.lastTorque().length());
    FrameStatistics counts = frame.statistics();
    assertTrue(counts.faults().badOrientations() > 0 && counts.faults().notFinite() > 0);
    freed += counts.freed();
    return judge.legs();
  }

  private ReadStatus read(HostilePoses hand, DeviceState state) {
    int fault = random.nextInt(50);
    if (fault == 0) {
      return ReadStatus.REPEATED;
    }
    deviceNanos += fault == 1 ? -2_000_000 : 1_000_000;
    Pose pose = hand.next();
    state
        .positionMm
        .set(pose.translation)
        .add(new Vec3(EDGE / 2.0, EDGE / 2.0, EDGE / 2.0), state.positionMm);
    state.orientation.set(pose.rotation);
    state.timeNanos = deviceNanos;
    return ReadStatus.FRESH;
  }

  private Edit edit(Pose pose) {
    int kind = random.nextInt(6);
    return kind == 0 ? HistoryEdit.undo() : kind == 1 ? HistoryEdit.redo() : editNear(pose);
  }

  private BrushEdit editNear(Pose pose) {
    Vec3 centre = new Vec3();
    for (int axis = 0; axis < 3; axis++) {
      double v = pose.translation.get(axis) + random.nextDouble(-4, 4);
      centre.set(axis, Math.max(0, Math.min(EDGE, v)));
    }
    return new BrushEdit(0, centre, random.nextDouble(0.5, 4), random.nextInt(3) != 0);
  }
}
