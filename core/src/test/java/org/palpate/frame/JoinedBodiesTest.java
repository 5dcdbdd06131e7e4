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
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.ReferencePose;
import org.palpate.testing.ScriptedDevice;

/** Holds a block with which others move along, among edits and events of a hostile recording. */
class JoinedBodiesTest extends HeldBlocks {
  /** It has room above. */
  private final Body floor = body("floor", 40, 40, 5, 40, Mobility.FIXED, new Vec3());

  private final Body block = cube("block", 8, new Vec3(16, 16, 8));
  private final Body small = cube("small", 4, new Vec3(30, 16, 12));
  private final Body other = cube("other", 3, new Vec3(8, 16, 12));
  private final BodyScene bodies = new BodyScene(List.of(floor, block, small, other));
  private final EditQueue edits = EditQueue.ofBodies(bodies.grids());
  private ReadStatus status = ReadStatus.FRESH;
  private final ToolFrame frame = newFrame(new ScriptedDevice(this::sample), bodies, edits, 4096);

  @Override
  ToolFrame frame() {
    return frame;
  }

  @Override
  ReadStatus sample(int read, DeviceState state) {
    super.sample(read, state);
    return status;
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
