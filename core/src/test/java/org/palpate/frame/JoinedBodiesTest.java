package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyEvent;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.edit.BrushEdit;
import org.palpate.edit.EditQueue;
import org.palpate.edit.HistoryEdit;
import org.palpate.force.ForceSettings;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.ReferencePose;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidScene;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.ScriptedDevice;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** Holds a block with which others move along, among edits and events of a hostile recording. */
class JoinedBodiesTest {
  private static final long MS = 1_000_000;
  private static final double INFINITE = Double.POSITIVE_INFINITY;
  private static final double STIFFNESS = 0.5;

  private final Body floor = body("floor", 5, new Vec3());
  private final Body block = body("block", 8, new Vec3(16, 16, 8));
  private final Body small = body("small", 4, new Vec3(30, 16, 12));
  private final Body other = body("other", 3, new Vec3(8, 16, 12));
  private final BodyScene bodies = new BodyScene(List.of(floor, block, small, other));
  private final EditQueue edits = EditQueue.ofBodies(bodies.grids());
  private final Vec3 hand = new Vec3(20, 20, 20);
  private ReadStatus status = ReadStatus.FRESH;
  private final ToolFrame frame = frame();
  private long nowNanos = 1;

  /** Makes a cube that can move, or a floor with room above. */
  private static Body body(String name, int edge, Vec3 at) {
    boolean moves = !name.equals("floor");
    int wide = moves ? edge : 40;
    BitCube bits = new BitCube(wide, wide, wide);
    for (int n = 0; n < wide * wide * edge; n++) {
      bits.set(n % wide, n / wide % wide, n / (wide * wide));
    }
    Mobility mobility = moves ? Mobility.MOVABLE : Mobility.FIXED;
    Body body = new Body(name, bits, VoxelGrid.ofUnitVoxels(wide, wide, wide), mobility);
    Pose pose = new Pose();
    pose.translation.set(at);
    body.setPose(pose);
    return body;
  }

  private ToolFrame frame() {
    RigidTool point = ToolSampler.point();
    MovableShapes shapes = MovableShapes.ofWholeBodies(bodies, 0);
    return new ToolFrame(
        new ScriptedDevice(this::sample),
        bodies,
        new RigidSolver(
            new RigidScene(bodies, point, shapes, RigidSettings.of(4, Clearance.POINTS))),
        RigidCoupling.of(point, STIFFNESS),
        new FrameSettings(
            ForceSettings.of(STIFFNESS, 0), INFINITE, INFINITE, 0, 20 * MS, 4096, 0, INFINITE),
        edits,
        ToolFramePublisher.NONE);
  }

  private ReadStatus sample(int read, DeviceState state) {
    ScriptedDevice.fresh(state, read, hand.x, hand.y, hand.z);
    return status;
  }

  private void run(int frames) {
    for (int n = 0; n < frames; n++) {
      frame.run(nowNanos);
      nowNanos += MS;
    }
  }

  private void moveTo(double x, double y, double z) {
    Vec3 way = new Vec3(x, y, z).sub(hand, new Vec3());
    int steps = (int) Math.ceil(way.length() * 10);
    way.mul(1.0 / steps, way);
    for (int n = 0; n < steps; n++) {
      hand.add(way, hand);
      run(1);
    }
    run(50);
  }

  private void takeBlock() {
    moveTo(20, 20, 15); // a millimetre below its upper face
    frame.requestTake();
    run(1);
    assertEquals(1, frame.heldBody());
  }

  private Vec3 fromBlock(Body body) {
    return ReferencePose.relative(block.pose(), body.pose(), new Pose()).translation;
  }

  private void join(int body) {
    frame.repeat(body, BodyEvent.JOINED, new Pose(), new Pose());
    run(1);
  }

  @Test
  void aBodyThatJoinsLaterMovesNoneThatJoinedBefore() {
    takeBlock();
    join(2);
    Vec3 before = new Vec3().set(fromBlock(small));
    moveTo(20, 20, 22);
    join(3);
    hand.x += 1;
    run(20);
    hand.x -= 1; // back to the pose at which the last one joined
    run(20);
    assertEquals(0, fromBlock(small).sub(before, new Vec3()).length(), 1e-8);
  }

  @Test
  void aGroupThatIsTakenRightAfterAnEditTouchedItStaysTogether() {
    frame.requestGroups(frame.groups().bound(1, 2));
    moveTo(20, 20, 15);
    Pose blockBefore = new Pose().set(block.pose());
    Vec3 before = new Vec3().set(fromBlock(small));
    assertTrue(edits.offer(new BrushEdit(0, new Vec3(20.5, 20.5, 8.5), 0.6, true)));
    status = ReadStatus.REPEATED;
    run(1);
    assertTrue(floor.bits().get(20, 20, 8), "a voxel of the floor stands in the block");
    status = ReadStatus.FRESH;
    frame.requestTake();
    run(1);
    assertEquals(1, frame.heldBody());
    moveTo(20, 20, 25);
    assertEquals(0, fromBlock(small).sub(before, new Vec3()).length(), 1e-8);
    assertTrue(block.pose().sameBits(blockBefore), "no leg is free, so it stays: " + block.pose());
  }

  @Test
  void aPlacementIsNotRepeatedWhileTheHandHoldsABody() {
    takeBlock();
    Pose held = new Pose().set(block.pose());
    Pose elsewhere = new Pose();
    elsewhere.translation.set(2, 2, 0);
    frame.repeat(1, BodyEvent.PLACED, elsewhere, new Pose());
    frame.repeat(2, BodyEvent.PLACED, elsewhere, new Pose());
    run(1);
    assertEquals(1, frame.heldBody());
    assertEquals(0, held.translation.sub(block.pose().translation, new Vec3()).length(), 1);
    assertEquals(30, small.pose().translation.x);
  }

  @Test
  void recordedEventsBeforeTheFirstSampleMoveBodiesOnceTheToolHasAPlace() {
    status = ReadStatus.REPEATED;
    Pose placed = new Pose();
    placed.translation.set(18, 16, 8);
    Pose goal = new Pose();
    goal.translation.set(30, 16, 20);
    frame.repeat(1, BodyEvent.PLACED, placed, new Pose());
    frame.repeat(2, BodyEvent.MOVED, goal, new Pose());
    run(5);
    assertEquals(12, small.pose().translation.z);
    status = ReadStatus.FRESH;
    run(50);
    assertTrue(block.pose().sameBits(placed));
    assertEquals(20, small.pose().translation.z, 1e-6);
  }

  @Test
  void aBodyIsTakenAgainAfterTheWholeUndo() {
    assertTrue(edits.offer(new BrushEdit(0, new Vec3(20, 20, 2), 100, false)));
    run(50);
    assertTrue(edits.offer(HistoryEdit.undo()));
    run(1);
    assertTrue(frame.voxels().history().isMoving());
    frame.repeat(1, BodyEvent.TAKEN, new Pose(), new Pose());
    run(1);
    assertFalse(frame.voxels().history().isMoving());
    assertEquals(1, frame.heldBody());
  }

  @Test
  void noBodyIsTakenAgainBetweenTwoUndosOfWhichOneIsInPart() {
    for (int n = 0; n < 2; n++) {
      assertTrue(edits.offer(new BrushEdit(0, new Vec3(20, 20, 2), 100, n == 1)));
      run(50);
    }
    assertTrue(edits.offer(HistoryEdit.undo()));
    assertTrue(edits.offer(HistoryEdit.undo()));
    frame.repeat(1, BodyEvent.TAKEN, new Pose(), new Pose());
    run(1);
    assertTrue(frame.heldBody() < 0 || !frame.voxels().history().isMoving());
    frame.repeat(1, BodyEvent.RELEASED, new Pose(), new Pose());
    run(50);
    assertEquals(-1, frame.heldBody());
    assertFalse(frame.voxels().history().isMoving());
  }

  @Test
  void editsThatCameBeforeABodyWasTakenAreRepeatedBeforeIt() {
    run(1);
    assertTrue(edits.offer(new BrushEdit(0, new Vec3(20.5, 20.5, 2.5), 0.6, false)));
    frame.repeat(1, BodyEvent.TAKEN, new Pose(), new Pose());
    run(1);
    assertEquals(1, frame.heldBody());
    assertFalse(floor.bits().get(20, 20, 2), "the edit of the same sample");
  }
}
