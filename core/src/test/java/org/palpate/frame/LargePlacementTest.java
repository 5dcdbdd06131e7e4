package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.edit.EditQueue;
import org.palpate.edit.HistoryEdit;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.testing.ScriptedDevice;

/** Undoes the placement of a large body where another one has come near. */
class LargePlacementTest extends HeldBlocks {
  private final Body floor = body("floor", 40, 40, 5, 5, Mobility.FIXED, new Vec3(0, 0, -22));
  private final Body block = cube("block", 32, new Vec3(4, 4, -16));
  private final Body other = cube("other", 32, new Vec3(70, 4, -16));
  private final BodyScene bodies = new BodyScene(List.of(floor, block, other));
  private final EditQueue edits = EditQueue.ofBodies(bodies.grids());
  private final ToolFrame frame = newFrame(new ScriptedDevice(this::sample), bodies, edits, 10_000);
  private final Pose start = new Pose().set(block.pose());
  private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  @Override
  ToolFrame frame() {
    return frame;
  }

  @Test
  void theLookAtItsPointsTakesSeveralFramesAndThenItReturnsToTheBit() {
    placeBlockAboveWhileTheOtherComesNear();
    Pose put = new Pose().set(block.pose());
    HistoryEdit undo = HistoryEdit.undo();
    assertTrue(edits.offer(undo));
    run(2);
    assertFalse(undo.isDone(), "it looks at " + frame.shape().count() + " points");
    assertTrue(block.pose().sameBits(put), "nothing moves before the look ends");
    run(40);
    assertTrue(undo.isDone());
    assertFalse(undo.isRefused());
    assertTrue(block.pose().sameBits(start), block.pose()::toString);
  }

  @Test
  void whatTheHandTakesMeanwhileIsTakenAndUndoWaitsUntilItLetsGo() {
    placeBlockAboveWhileTheOtherComesNear();
    moveTo(60, 20, 20);
    moveTo(60, 20, 15); // into the upper face of the other
    assertTrue(frame.motion().contact());
    Pose near = new Pose().set(other.pose());
    HistoryEdit undo = HistoryEdit.undo();
    assertTrue(edits.offer(undo));
    run(2);
    assertFalse(undo.isDone());
    frame.requestTake();
    run(50);
    assertEquals(2, frame.heldBody());
    assertFalse(undo.isDone());
    moveTo(60, 20, 25);
    frame.requestLetGo();
    run(50);
    assertTrue(undo.isDone());
    assertTrue(other.pose().sameBits(near), "the last placement is undone: " + other.pose());
  }

  @Test
  void theLookAllocatesNothing() {
    placeBlockAboveWhileTheOtherComesNear();
    long least = Long.MAX_VALUE;
    long leastIdle = 0; // what the scripted device keeps
    for (int round = 0; round < 200 && least > leastIdle; round++) {
      HistoryEdit undo = HistoryEdit.undo();
      assertTrue(edits.offer(undo));
      long before = threads.getCurrentThreadAllocatedBytes();
      run(2);
      assertFalse(undo.isDone());
      run(40);
      least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
      assertTrue(undo.isDone());
      assertTrue(block.pose().sameBits(start), block.pose()::toString);
      assertTrue(edits.offer(HistoryEdit.redo()));
      run(40);
      before = threads.getCurrentThreadAllocatedBytes();
      run(42);
      long idle = threads.getCurrentThreadAllocatedBytes() - before;
      leastIdle = round == 0 ? idle : Math.min(leastIdle, idle);
    }
    assertTrue(least <= leastIdle, least + " bytes, without undo " + leastIdle);
  }

  private void placeBlockAboveWhileTheOtherComesNear() {
    placeBlockAbove(60);
    Pose goal = Pose.at(40, 4, -16); // 4 mm beside where the block was
    frame.requestPose(2, goal);
    run(400);
    assertTrue(other.pose().translation.sub(goal.translation, new Vec3()).length() < 1e-6);
  }
}
