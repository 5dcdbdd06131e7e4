package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.palpate.testing.ScriptedDevice.fresh;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.collision.CollisionScene;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.edit.BrushEdit;
import org.palpate.edit.BrushLimits;
import org.palpate.edit.BrushPath;
import org.palpate.edit.EditQueue;
import org.palpate.edit.ShapeEdit;
import org.palpate.force.ForceSettings;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.loop.ManualClock;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.ScriptedDevice;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** Paints at the tool with whole frames of a point and of a rigid tool. */
class BrushFramesTest {
  private static final int EDGE = 24;
  private static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE);
  private static final BrushLimits SPARES_TOOL =
      new BrushLimits(Optional.empty(), Optional.empty(), true);

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final BitCube bits = new BitCube(EDGE, EDGE, EDGE);
  private final EditQueue edits = EditQueue.ofBodies(List.of(GRID));
  private final RigidTool tool = ToolSampler.ofShape(RodShape.capsule(2, 4), 0.498);
  private final Pose pose = new Pose();
  private final ScriptedDevice device = new ScriptedDevice((read, state) -> read(state));
  private long nowNanos = 1;

  BrushFramesTest() {
    for (int n = 0; n < EDGE * EDGE; n++) {
      for (int k = 0; k < 8; k++) {
        bits.set(n % EDGE, n / EDGE, k);
      }
    }
    pose.translation.set(12, 12, 18);
  }

  @Test
  void theShapeOfTheToolErasesWhatItWouldHoldAtTheDevice() {
    ToolFrame frame = toolFrame();
    run(frame, 5);
    pose.translation.z = 7;
    pose.rotation.setRotationVector(new Vec3(0.4, 0.9, 0));
    run(frame, 50);
    BitCube before = bits.copy();
    edits.offer(new ShapeEdit(0, tool.solid()::contains, 4.5, false, BrushLimits.NONE));
    run(frame, 1);
    Vec3 p = new Vec3();
    RodShape shape = RodShape.capsule(2, 4);
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      int i = n % EDGE;
      int j = n / EDGE % EDGE;
      int k = n / (EDGE * EDGE);
      pose.inverseTransform(p.set(i + 0.5, j + 0.5, k + 0.5), p);
      boolean expected = before.get(i, j, k) && !shape.contains(p.x, p.y, p.z);
      assertEquals(expected, bits.get(i, j, k));
    }
    assertTrue(before.solidCount() - bits.solidCount() > 10);
    assertEquals(0, frame.statistics().freed());
  }

  @Test
  void addedVoxelsPushTheToolOut() {
    ToolFrame frame = toolFrame();
    run(frame, 5);
    edits.offer(BrushEdit.atTool(0, new BrushPath(), 2, true, BrushLimits.NONE));
    run(frame, 1);
    assertTrue(frame.wasFreed());
    assertEquals(1, frame.statistics().freed());
    assertTrue(bits.get(12, 12, 18));
  }

  /** No frame sets a tool free that its brush spares, and the tool ends up walled in. */
  @Test
  void voxelsThatWouldMeetTheToolAreRefused() {
    ToolFrame frame = toolFrame();
    run(frame, 5);
    BrushPath path = new BrushPath();
    for (int n = 0; n < 200; n++) {
      pose.translation.set(12 + 6 * Math.sin(n * 0.05), 12, 16 - n * 0.02);
      pose.rotation.setRotationVector(new Vec3(0.01 * n, 0, 0.3));
      edits.offer(BrushEdit.atTool(0, path, random.nextDouble(1, 6), true, SPARES_TOOL));
      run(frame, 1);
      assertFalse(frame.wasFreed(), "seed " + Seeds.seed() + " frame " + n);
    }
    assertTrue(bits.solidCount() > EDGE * EDGE * 8 + 500, "voxels " + bits.solidCount());
    assertEquals(0, frame.mostReducedPoints());
  }

  @Test
  void aPointIsSparedOrPushedOutAsAsked() {
    PointFrame frame = pointFrame();
    run(frame, 5);
    edits.offer(BrushEdit.atTool(0, new BrushPath(), 3, true, SPARES_TOOL));
    run(frame, 1);
    assertFalse(frame.wasFreed());
    assertFalse(bits.get(12, 12, 18));
    assertTrue(bits.get(13, 13, 18));
    edits.offer(BrushEdit.atTool(0, new BrushPath(), 3, true, BrushLimits.NONE));
    run(frame, 1);
    assertTrue(frame.wasFreed());
  }

  /** The point lies on the edge of four voxels. */
  @Test
  void aPointSparesEveryVoxelThatItTouches() {
    PointFrame frame = pointFrame();
    pose.translation.set(12, 12.5, 18);
    run(frame, 5);
    edits.offer(BrushEdit.atTool(0, new BrushPath(), 3, true, SPARES_TOOL));
    run(frame, 1);
    assertFalse(frame.wasFreed());
    for (int i = 11; i <= 12; i++) {
      assertFalse(bits.get(i, 12, 17) || bits.get(i, 12, 18), "i=" + i);
    }
    assertTrue(bits.get(10, 12, 17) && bits.get(13, 12, 18) && bits.get(11, 13, 18));
    assertTrue(bits.get(12, 12, 19) && bits.get(12, 12, 16) && bits.get(11, 11, 17));
  }

  @Test
  void aPointErasesWhereItTouchesAndNotWhereTheHandIs() {
    PointFrame frame = pointFrame();
    run(frame, 5);
    pose.translation.set(12.5, 12.5, 1.5);
    run(frame, 100);
    assertEquals(8, frame.point().position.z, 1e-3);
    edits.offer(BrushEdit.atTool(0, new BrushPath(), 1.2, false, BrushLimits.NONE));
    run(frame, 1);
    assertFalse(bits.get(12, 12, 7));
    assertTrue(bits.get(12, 12, 1));
  }

  private ToolFrame toolFrame() {
    BodyScene bodies = new BodyScene(List.of(new Body("solid", bits, GRID, Mobility.FIXED)));
    return new ToolFrame(
        device,
        bodies,
        new RigidSolver(bodies, tool, RigidSettings.ofWholeBodies(5, bodies, tool)),
        RigidCoupling.of(tool, 0.5),
        settings(),
        edits,
        ToolFramePublisher.NONE);
  }

  private PointFrame pointFrame() {
    pose.translation.set(12.5, 12.5, 18.5);
    return new PointFrame(
        GridDevice.inGridCoordinates(device),
        new GuardedSolver(GRID.metric(), 5),
        new CollisionScene(List.of(bits)),
        GRID.metric(),
        settings(),
        edits,
        FramePublisher.NONE);
  }

  private static FrameSettings settings() {
    double infinite = Double.POSITIVE_INFINITY;
    return new FrameSettings(
        ForceSettings.of(0.5, 0), infinite, infinite, 0, FrameSettings.NO_SILENCE, 1 << 20);
  }

  private ReadStatus read(DeviceState state) {
    state.orientation.set(pose.rotation);
    Vec3 at = pose.translation;
    return fresh(state, nowNanos / ManualClock.MS, at.x, at.y, at.z);
  }

  private void run(HapticFrame frame, int frames) {
    for (int n = 0; n < frames; n++) {
      nowNanos += ManualClock.MS;
      assertEquals(FrameOutcome.RUNNING, frame.run(nowNanos));
    }
  }
}
