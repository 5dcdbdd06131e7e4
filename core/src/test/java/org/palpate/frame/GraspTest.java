package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.edit.BrushEdit;
import org.palpate.edit.EditQueue;
import org.palpate.edit.HistoryEdit;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.ReferencePose;
import org.palpate.testing.ScriptedDevice;
import org.palpate.testing.Seeds;

/** Takes hold of a block that lies over a floor, and lets go of it. */
class GraspTest extends HeldBlocks {
  private final Body floor = body("floor", 40, 40, 5, 5, Mobility.FIXED, new Vec3());
  private final Body block = cube("block", 8, new Vec3(16, 16, 8));
  private final Body small = cube("small", 4, new Vec3(30, 16, 8));
  private final BodyScene bodies = new BodyScene(List.of(floor, block, small));
  private final EditQueue edits = EditQueue.ofBodies(bodies.grids());
  private final Quaternion turn = new Quaternion();
  private final ScriptedDevice device = new ScriptedDevice(this::sample);
  private final ToolFrame frame = newFrame(device, bodies, edits, 64);

  @Override
  ReadStatus sample(int read, DeviceState state) {
    state.orientation.set(turn);
    return super.sample(read, state);
  }

  @Override
  ToolFrame frame() {
    return frame;
  }

  @Test
  void aBodyThatIsTakenStaysWhereItIsAndTheForceHasNoStep() {
    moveTo(20, 20, 15);
    Vec3 before = new Vec3().set(device.lastForce());
    assertTrue(before.z > 0.3, "force " + before);
    Pose rest = new Pose().set(block.pose());
    frame.requestTake();
    run(1);
    assertEquals(1, frame.heldBody());
    Vec3 first = device.forces.get(device.forces.size() - 1);
    Vec3 moved = block.pose().translation.sub(rest.translation, new Vec3());
    double step = first.sub(before, new Vec3()).length();
    assertTrue(step <= STIFFNESS * moved.length() + 1e-6, "step of " + step + " N");
    assertEquals(0, device.lastTorque().length(), 0.5);
  }

  @Test
  void aHeldBodyMovesWithTheHandStopsAtTheFloorAndStaysWhereItIsLetGo() {
    takeBlock();
    moveTo(20, 20, 25);
    assertEquals(17, block.pose().translation.z, 0.5, "lifted with the hand");
    turn.setRotationVector(new Vec3(0, 0, 0.5));
    run(200);
    assertEquals(0.5, block.pose().rotation.angle(), 1e-6);
    moveTo(22, 20, 2);
    assertTrue(block.pose().translation.z >= 5, "above the floor: " + block.pose());
    assertTrue(block.pose().translation.z < 7, "down to the floor: " + block.pose());
    Vec3 pressed = new Vec3().set(device.lastForce());
    assertTrue(pressed.z > 1, "pushes the hand up: " + pressed);
    Pose put = new Pose().set(block.pose());
    frame.requestLetGo();
    run(1);
    assertEquals(-1, frame.heldBody());
    assertTrue(block.pose().sameBits(put));
    assertEquals(0, frame.statistics().freed());
    double step = device.lastForce().sub(pressed, new Vec3()).length();
    assertTrue(step < 0.3 * pressed.length(), "step of " + step + " N");
    moveTo(20, 20, 40);
    assertTrue(block.pose().sameBits(put));
    assertTrue(frame.motion().pose().translation.sameBits(hand), "the tool is back at the hand");
  }

  @Test
  void aBodyGoesToARequestedPoseAndStopsWhereAnotherIsInItsWay() {
    Pose goal = new Pose();
    goal.rotation.setRotationVector(new Vec3(0, 0, 0.3));
    goal.translation.set(12, 18, 20);
    moveTo(0, 0, 60);
    frame.requestPose(1, goal);
    run(400);
    assertEquals(0, goal.translation.sub(block.pose().translation, new Vec3()).length(), 1e-6);
    assertEquals(0.3, block.pose().rotation.angle(), 1e-6);
    goal.translation.z = -5;
    frame.requestPose(1, goal);
    run(400);
    double z = block.pose().translation.z;
    assertTrue(z > 5 && z < 6, "over the floor: " + block.pose());
    frame.requestPose(1, new Pose().set(block.pose())); // what it could not reach is forgotten
    run(10);
    assertTrue(frame.motion().bodies().count() == 0, "at rest");
  }

  @Test
  void aRequestedPoseWaitsForNobodyWhoHoldsTheBodyAndUndoIsNotReversed() {
    Pose start = new Pose().set(block.pose());
    Pose goal = new Pose();
    goal.translation.set(2, 2, 30);
    takeBlock();
    frame.requestPose(1, goal);
    moveTo(20, 20, 25);
    assertEquals(17, block.pose().translation.z, 0.5, "where the hand leads it");
    frame.requestLetGo();
    run(200);
    assertEquals(17, block.pose().translation.z, 0.5, "where it was let go");
    frame.requestPose(1, goal);
    run(5);
    assertTrue(block.pose().translation.x < 16, "on its way");
    undo();
    assertTrue(block.pose().sameBits(start));
    run(50);
    assertTrue(block.pose().sameBits(start));
  }

  @Test
  void onlyABodyThatCanMoveTakesAFinitePose() {
    Pose goal = new Pose();
    assertThrows(IllegalArgumentException.class, () -> frame.requestPose(0, goal));
    goal.translation.y = Double.NaN;
    assertThrows(IllegalArgumentException.class, () -> frame.requestPose(1, goal));
    goal.translation.y = 0;
    goal.rotation.w = 2;
    assertThrows(IllegalArgumentException.class, () -> frame.requestPose(1, goal));
  }

  @Test
  void aHeldBodyPushesAgainstOthersWhicheverCarriesThePoints() {
    takeBlock();
    moveTo(28, 20, 15);
    assertTrue(block.pose().translation.x <= 22, "stopped by the small one: " + block.pose());
    assertTrue(block.pose().translation.x > 20.5, "but near it: " + block.pose());
    assertTrue(device.lastForce().x < -1, "force " + device.lastForce());
    assertEquals(30, small.pose().translation.x);
  }

  @Test
  void placementsAreUndoneAndDoneAgainToTheBitAndEachSetsTheToolFree() {
    Pose[] poses = new Pose[4];
    poses[0] = new Pose().set(block.pose());
    takeBlock();
    for (int n = 1; n < poses.length; n++) {
      turn.setRotationVector(new Vec3(0.1 * n, 0.05, -0.1));
      moveTo(18 + n, 21, 22 + n);
      frame.requestLetGo();
      run(1);
      poses[n] = new Pose().set(block.pose());
      frame.requestTake();
      moveTo(hand.x, hand.y, hand.z - 3); // the point lies on the block, so this presses it
      if (frame.heldBody() < 0) {
        frame.requestTake();
        run(1);
      }
      assertEquals(1, frame.heldBody(), "placement " + n);
    }
    frame.requestLetGo();
    run(1);
    Pose last = new Pose().set(block.pose());
    long freed = frame.statistics().freed();
    undo();
    for (int n = poses.length - 1; n >= 1; n--) {
      assertTrue(block.pose().sameBits(poses[n]), "placement " + n + ": " + block.pose());
      undo();
    }
    assertTrue(block.pose().sameBits(poses[0]));
    assertEquals(freed + poses.length, frame.statistics().freed());
    undo();
    assertTrue(block.pose().sameBits(poses[0]), "there is nothing more to undo");
    for (int n = 1; n < poses.length; n++) {
      redo();
      assertTrue(block.pose().sameBits(poses[n]), "placement " + n);
    }
    redo();
    assertTrue(block.pose().sameBits(last));
  }

  private void undo() {
    assertTrue(edits.offer(HistoryEdit.undo()));
    run(1);
  }

  private void redo() {
    assertTrue(edits.offer(HistoryEdit.redo()));
    run(1);
  }

  @Test
  void boundBodiesMoveAsOneStopTogetherAndAreUndoneAndRedoneTogether() {
    frame.requestGroups(frame.groups().bound(1, 2));
    Pose blockBefore = new Pose().set(block.pose());
    Pose smallBefore = new Pose().set(small.pose());
    Pose relative = ReferencePose.relative(block.pose(), small.pose(), new Pose());
    takeBlock();
    moveTo(20, 20, 22);
    turn.setRotationVector(new Vec3(0, 0.4, 0));
    run(200);
    Pose now = ReferencePose.relative(block.pose(), small.pose(), new Pose());
    assertEquals(0, now.translation.sub(relative.translation, new Vec3()).length(), 1e-8);
    assertTrue(small.pose().translation.sub(smallBefore.translation, new Vec3()).length() > 4);
    moveTo(20, 20, 2);
    assertFalse(entersAnother(small, 4, floor), "the group stops where its lowest body stops");
    assertTrue(block.pose().translation.z >= 5, "above the floor: " + block.pose());
    Pose blockPut = new Pose().set(block.pose());
    Pose smallPut = new Pose().set(small.pose());
    frame.requestLetGo();
    run(1);
    undo();
    assertTrue(block.pose().sameBits(blockBefore) && small.pose().sameBits(smallBefore));
    redo();
    assertTrue(block.pose().sameBits(blockPut) && small.pose().sameBits(smallPut));
    undo();
    frame.requestGroups(frame.groups().alone(2));
    moveTo(hand.x, hand.y, 30);
    turn.setIdentity();
    takeBlock();
    moveTo(20, 20, 25);
    assertTrue(small.pose().sameBits(smallBefore), "it moves alone again");
  }

  @Test
  void aLockedBodyOrOneThatIsBoundToItIsNotTaken() {
    frame.requestGroups(frame.groups().withLock(1, true));
    moveTo(20, 20, 15);
    assertEquals(1, frame.chosenBody());
    frame.requestTake();
    run(1);
    assertEquals(-1, frame.heldBody());
    frame.requestGroups(frame.groups().withLock(1, false).withLock(2, true).bound(1, 2));
    frame.requestTake();
    run(1);
    assertEquals(-1, frame.heldBody());
    frame.requestGroups(frame.groups().withLock(1, false));
    frame.requestTake();
    run(1);
    assertEquals(1, frame.heldBody());
    assertThrows(
        IllegalArgumentException.class, () -> frame.requestGroups(frame.groups().bound(0, 1)));
  }

  @Test
  void aMovableBodyGainsNoVoxelButWhatWasErasedComesBack() {
    long solid = block.bits().solidCount();
    run(1);
    assertTrue(edits.offer(new BrushEdit(1, new Vec3(20, 20, 20), 30, true)));
    run(2000);
    assertEquals(solid, block.bits().solidCount(), "its sample points would not cover a new voxel");
    assertTrue(edits.offer(new BrushEdit(1, new Vec3(20, 20, 20), 30, false)));
    run(2000);
    assertTrue(block.bits().solidCount() < solid);
    assertTrue(edits.offer(new BrushEdit(1, new Vec3(20, 20, 20), 30, true)));
    run(2000);
    assertEquals(solid, block.bits().solidCount());
  }

  @Test
  void aBodyIsTakenOnlyOnceAnUndoOfSeveralFramesIsWhole() {
    long solid = floor.bits().solidCount();
    assertTrue(edits.offer(new BrushEdit(0, new Vec3(3, 3, 3), 8, false)));
    moveTo(20, 20, 15);
    assertTrue(frame.motion().contact());
    assertTrue(floor.bits().solidCount() < solid);
    undo();
    assertTrue(frame.voxels().history().isMoving(), "the undo takes several frames");
    frame.requestTake();
    run(1);
    assertEquals(-1, frame.heldBody());
    run(50);
    assertFalse(frame.voxels().history().isMoving());
    assertEquals(1, frame.heldBody());
    moveTo(20, 20, 20);
    frame.requestLetGo();
    run(1);
    assertEquals(solid, floor.bits().solidCount());
    Pose put = new Pose().set(block.pose());
    undo();
    assertFalse(block.pose().sameBits(put));
    redo();
    assertTrue(block.pose().sameBits(put));
    assertEquals(solid, floor.bits().solidCount());
  }

  @Test
  void aHeldBodyNeverEntersAnotherWhateverEditsUndoAndJumpsMeet() {
    attack();
  }

  @Test
  void aGroupNeverEntersTheFloorWhateverEditsUndoAndJumpsMeet() {
    frame.requestGroups(frame.groups().bound(1, 2));
    attack();
  }

  private void attack() {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    device.script = (read, state) -> hostileSample(random, read, state);
    int moved = 0;
    for (int n = 0; n < 20_000; n++) {
      act(random);
      int held = frame.heldBody();
      boolean apart = frame.motion().reducedPoints() == 0 && !entersAnother();
      Pose before = new Pose().set(block.pose());
      run(1);
      if (held == 1 && frame.heldBody() == 1 && apart) {
        String where = "seed " + Seeds.seed() + " frame " + n;
        assertFalse(entersAnother(), where);
        moved += block.pose().sameBits(before) ? 0 : 1;
      }
    }
    assertTrue(moved > 1000, "frames in which the block moved: " + moved);
  }

  private ReadStatus hostileSample(SplittableRandom random, int read, DeviceState state) {
    hand.x += random.nextDouble(-0.3, 0.3) + 0.01 * (20 - hand.x);
    hand.y += random.nextDouble(-0.3, 0.3) + 0.01 * (20 - hand.y);
    hand.z += random.nextDouble(-0.3, 0.3) + 0.01 * (13 - hand.z);
    turn.setRotationVector(new Vec3(0.3 * Math.sin(read / 900.0), 0, 0.5 * Math.sin(read / 700.0)));
    if (random.nextInt(300) == 0) {
      state.relocated = true;
      hand.set(random.nextDouble(5, 35), 18, random.nextDouble(4, 30));
    }
    return random.nextInt(20) == 0 ? ReadStatus.REPEATED : sample(read, state);
  }

  private boolean entersAnother() {
    return entersAnother(block, 8, floor)
        || entersAnother(block, 8, small)
        || (frame.groups().moveTogether(1, 2) && entersAnother(small, 4, floor));
  }

  /** Whether a corner of a voxel of a cube lies in a voxel of another body. */
  private static boolean entersAnother(Body cube, int edge, Body other) {
    Vec3 world = new Vec3();
    int corners = edge + 1;
    for (int n = 0; n < corners * corners * corners; n++) {
      int j = n / corners % corners;
      int k = n / (corners * corners);
      world.set(n % corners, j, k);
      if (isInside(other, cube.pose().transform(world, world))) {
        return true;
      }
    }
    return false;
  }

  private static boolean isInside(Body body, Vec3 worldMm) {
    Vec3 p = body.pose().inverseTransform(worldMm, new Vec3());
    return body.bits().get((int) Math.floor(p.x), (int) Math.floor(p.y), (int) Math.floor(p.z));
  }

  private void act(SplittableRandom random) {
    switch (random.nextInt(200)) {
      case 0, 1, 2, 3, 4 -> frame.requestTake();
      case 5, 6 -> frame.requestLetGo();
      case 7, 8 -> edits.offer(HistoryEdit.undo());
      case 9, 10 -> edits.offer(HistoryEdit.redo());
      case 11 -> {
        Vec3 centre = new Vec3(random.nextDouble(40), random.nextDouble(40), random.nextDouble(5));
        edits.offer(new BrushEdit(0, centre, random.nextDouble(6), random.nextBoolean()));
      }
      default -> {}
    }
  }

  @Test
  void nothingIsTakenWithoutContactOrIfTheToolTouchesWhatStandsStill() {
    run(5);
    frame.requestTake();
    run(1);
    assertEquals(-1, frame.heldBody());
    moveTo(5, 5, 20);
    moveTo(5, 5, 4);
    assertTrue(frame.motion().contact());
    frame.requestTake();
    run(1);
    assertEquals(-1, frame.heldBody());
    frame.requestLetGo();
    run(1);
    assertFalse(frame.motion().freed());
  }
}
