package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

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

/** Undoes placements after another body has moved by itself to where a body was. */
class UndonePlacementTest extends HeldBlocks {
  private final Body floor = body("floor", 40, 40, 5, 5, Mobility.FIXED, new Vec3());
  private final Body block = cube("block", 8, new Vec3(16, 16, 8));
  private final Body small = cube("small", 4, new Vec3(24.25, 18, 8)); // nearer than the clearance
  private final BodyScene bodies = new BodyScene(List.of(floor, block, small));
  private final EditQueue edits = EditQueue.ofBodies(bodies.grids());
  private final ToolFrame frame = newFrame(new ScriptedDevice(this::sample), bodies, edits, 10_000);
  private final Pose start = new Pose().set(block.pose());
  private long refusedBefore;

  @Override
  ToolFrame frame() {
    return frame;
  }

  @Test
  void aBodyReturnsToTheBitNearAnotherThatHasNotMoved() {
    placeBlockAbove();
    offer(HistoryEdit.undo());
    assertTrue(block.pose().sameBits(start), block.pose()::toString);
    assertEquals(0, frame.voxels().history().refused());
  }

  @Test
  void undoIsRefusedAsLongAsAnotherBodyIsThere() {
    placeBlockAbove();
    Pose put = new Pose().set(block.pose());
    moveSmallTo(18, 18, 10);
    offer(HistoryEdit.undo());
    assertTrue(block.pose().sameBits(put), block.pose()::toString);
    assertEquals(1, frame.voxels().history().refused());
    moveSmallTo(32, 18, 10);
    offer(HistoryEdit.undo());
    assertTrue(block.pose().sameBits(start), block.pose()::toString);
    assertEquals(1, frame.voxels().history().refused());
  }

  @Test
  void undoIsRefusedIfSolidsWouldBeNearerThanTheClearance() {
    placeBlockAbove();
    Pose put = new Pose().set(block.pose());
    moveSmallTo(24.5, 19, 8.5);
    offer(HistoryEdit.undo());
    assertTrue(block.pose().sameBits(put), block.pose()::toString);
    assertEquals(1, frame.voxels().history().refused());
  }

  @Test
  void aBodyThatWentAndCameBackToTheBitIsNotInTheWayThoughItIsNearerThanTheClearance() {
    Pose smallAtStart = new Pose().set(small.pose());
    placeBlockAbove();
    moveSmallTo(24.5, 19, 8.5);
    small.setPose(smallAtStart); // a program may set poses
    offer(HistoryEdit.undo());
    assertTrue(block.pose().sameBits(start), block.pose()::toString);
    assertEquals(0, frame.voxels().history().refused());
  }

  @Test
  void redoIsRefusedAsLongAsAnotherBodyIsThere() {
    placeBlockAbove();
    Pose put = new Pose().set(block.pose());
    offer(HistoryEdit.undo());
    Vec3 above = put.translation;
    moveSmallTo(32, 18, above.z); // around the block
    moveSmallTo(above.x + 2, above.y + 2, above.z + 2);
    offer(HistoryEdit.redo());
    assertTrue(block.pose().sameBits(start), block.pose()::toString);
    assertEquals(1, frame.voxels().history().refused());
    moveSmallTo(32, 18, above.z);
    offer(HistoryEdit.redo());
    assertTrue(block.pose().sameBits(put), block.pose()::toString);
  }

  @Test
  void aBodyThatUndoBringsBackFromWhereItStrayedIsInTheWayOfLaterPlacements() {
    placeBlockAbove();
    moveTo(20, 20, 50);
    Pose astray = new Pose();
    astray.translation.set(0, 0, 30);
    frame.requestPose(1, astray);
    run(200);
    assertTrue(block.pose().translation.x < 0.1, block.pose()::toString);
    takeSmallAndPutItWhereTheBlockWas();
    Pose put = new Pose().set(small.pose());
    offer(HistoryEdit.undo()); // small
    offer(HistoryEdit.undo()); // block, from astray
    assertTrue(block.pose().sameBits(start), block.pose()::toString);
    offer(HistoryEdit.redo()); // block, to where it was put
    offer(HistoryEdit.redo());
    assertFalse(small.pose().sameBits(put), "it would be in the block");
    assertEquals(1, frame.voxels().history().refused());
  }

  private void takeSmallAndPutItWhereTheBlockWas() {
    moveTo(26, 20, 20);
    moveTo(26, 20, 11);
    frame.requestTake();
    run(1);
    assertEquals(2, frame.heldBody());
    moveTo(26, 20, 24);
    moveTo(20, 20, 24);
    frame.requestLetGo();
    run(1);
  }

  private void placeBlockAbove() {
    placeBlockAbove(30);
    assertTrue(block.pose().translation.z > 20, block.pose()::toString);
  }

  private void moveSmallTo(double x, double y, double z) {
    Pose goal = new Pose();
    goal.translation.set(x, y, z);
    frame.requestPose(2, goal);
    run(400);
    assertTrue(small.pose().translation.sub(goal.translation, new Vec3()).length() < 1e-6);
  }

  private void offer(HistoryEdit edit) {
    assertTrue(edits.offer(edit));
    for (int n = 0; n < 20 && !edit.isDone(); n++) {
      run(1);
    }
    assertTrue(edit.isDone());
    assertEquals(refusedBefore + (edit.isRefused() ? 1 : 0), frame.voxels().history().refused());
    refusedBefore = frame.voxels().history().refused();
  }
}
