package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
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
import org.palpate.force.GreyMaterials;
import org.palpate.force.guide.NearestApproach;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.testing.ScriptedDevice;
import org.palpate.volume.ScalarVolume;

/** Frames in which the hand takes, moves and lets go of a block over a floor, and their reports. */
class HeldBodyFramesTest extends HeldBlocks {
  /** An event as a listener receives it. */
  private record Event(int body, BodyEvent event, Pose pose, Pose inHand) {}

  /** A copy of a record. */
  private record Seen(
      Vec3 deviceMm, Pose tool, boolean contact, int held, List<Integer> objects, double shares) {
    static Seen of(FrameRecord record) {
      List<Integer> objects = new ArrayList<>();
      double shares = 0;
      for (int n = 0; n < record.contacts(); n++) {
        objects.add(record.object(n));
        shares += record.share(n);
      }
      return new Seen(
          new Vec3().set(record.deviceMm),
          new Pose().set(record.tool),
          record.contact,
          record.heldBody,
          objects,
          shares);
    }
  }

  private final Body floor = body("floor", 40, 40, 5, 5, Mobility.FIXED, new Vec3());
  private final Body block = cube("block", 8, new Vec3(16, 16, 8));
  private final Body small = cube("small", 4, new Vec3(30, 16, 8));
  private final BodyScene bodies = new BodyScene(List.of(floor, block, small));
  private final EditQueue edits = EditQueue.ofBodies(bodies.grids());
  private final Quaternion turn = new Quaternion();
  private final ScriptedDevice device = new ScriptedDevice(this::sample);
  private final List<Event> events = new ArrayList<>();
  private int buttons;
  private boolean jumps;
  private ToolFrame frame = newFrame(device, bodies, edits, 64);

  @Override
  ReadStatus sample(int read, DeviceState state) {
    state.orientation.set(turn);
    state.buttons = buttons;
    state.relocated = jumps;
    return super.sample(read, state);
  }

  @Override
  ToolFrame frame() {
    return frame;
  }

  private void listen() {
    frame.listen(
        (body, event, pose, inHand) ->
            events.add(new Event(body, event, new Pose().set(pose), new Pose().set(inHand))));
  }

  private List<Event> eventsOf(int body) {
    return events.stream().filter(each -> each.body == body).toList();
  }

  private Event last(int body) {
    List<Event> all = eventsOf(body);
    return all.get(all.size() - 1);
  }

  @Test
  void aListenerReceivesEveryEventOfTheBodiesThatMoveAndNoneOfTheOthers() {
    listen();
    frame.requestGroups(frame.groups().bound(1, 2));
    Pose blockAtStart = new Pose().set(block.pose());
    takeBlock();
    assertEquals(BodyEvent.TAKEN, eventsOf(1).get(0).event);
    assertTrue(eventsOf(1).get(0).pose.sameBits(blockAtStart));
    assertEquals(BodyEvent.JOINED, eventsOf(2).get(0).event);
    events.clear();
    moveTo(20, 20, 18);
    assertEquals(BodyEvent.HELD, last(1).event);
    assertTrue(last(1).pose.sameBits(block.pose()));
    assertEquals(BodyEvent.HELD, last(2).event);
    assertTrue(last(2).pose.sameBits(small.pose()));
    run(300);
    int before = events.size();
    run(5);
    assertEquals(before, events.size(), "no report of a body at rest");
    frame.requestLetGo();
    run(1);
    assertEquals(BodyEvent.RELEASED, last(1).event);
    assertTrue(edits.offer(HistoryEdit.undo()));
    run(2); // one body a frame
    assertEquals(BodyEvent.PLACED, last(1).event);
    assertTrue(last(1).pose.sameBits(blockAtStart));
    assertEquals(BodyEvent.PLACED, last(2).event);
    Pose goal = new Pose();
    goal.translation.set(4, 4, 30);
    frame.requestPose(1, goal);
    run(3);
    assertEquals(BodyEvent.MOVED, last(1).event);
    assertTrue(last(1).pose.sameBits(block.pose()));
    assertTrue(eventsOf(0).isEmpty());
  }

  @Test
  void anObserverSeesThePressedBodyAndThenTheOneInHand() {
    List<Seen> seen = new ArrayList<>();
    frame.observe(record -> seen.add(Seen.of(record)));
    moveTo(20, 20, 15);
    Seen pressing = seen.get(seen.size() - 1);
    assertTrue(pressing.deviceMm.sameBits(hand));
    assertTrue(pressing.tool.sameBits(frame.motion().pose()));
    assertTrue(pressing.contact);
    assertEquals(-1, pressing.held);
    assertTrue(pressing.objects.stream().allMatch(object -> object == 1), "" + pressing.objects);
    assertEquals(1, pressing.shares, 1e-12);
    assertFalse(seen.get(0).contact);
    assertEquals(0, seen.get(0).shares);
    frame.requestTake();
    moveTo(20, 20, 25);
    Seen holding = seen.get(seen.size() - 1);
    assertEquals(1, holding.held);
    assertTrue(holding.tool.translation.sameBits(frame.motion().pose().translation));
    assertTrue(holding.deviceMm.sameBits(hand));
  }

  @Test
  void theFirstButtonTakesAndItsReleaseLetsGo() {
    moveTo(20, 20, 15);
    buttons = 1;
    run(2);
    assertEquals(1, frame.heldBody());
    run(5);
    assertEquals(1, frame.heldBody());
    buttons = 0;
    run(1);
    assertEquals(-1, frame.heldBody());
  }

  @Test
  void aDeviceThatJumpsLetsGoOfTheBodyAndTheToolIsAtTheDevice() {
    listen();
    takeBlock();
    moveTo(20, 20, 22);
    Pose held = new Pose().set(block.pose());
    jumps = true;
    hand.set(5, 5, 40);
    run(1);
    assertEquals(-1, frame.heldBody());
    assertTrue(frame.wasFreed());
    assertEquals(0, device.lastForce().length());
    assertTrue(frame.motion().pose().translation.sameBits(hand));
    assertTrue(block.pose().sameBits(held));
    assertEquals(BodyEvent.RELEASED, last(1).event);
    jumps = false;
    run(1);
    assertFalse(frame.wasFreed());
  }

  /** The coupling acts at the block, and the torque is about the hand beside it. */
  @Test
  void theTorqueOnTheHandIsThatOfTheCouplingAboutTheDevicesPoint() {
    listen();
    moveTo(23, 20, 15);
    frame.requestTake();
    run(1);
    Pose inHand = eventsOf(1).get(0).inHand;
    moveTo(23, 20, 25);
    turn.setRotationVector(new Vec3(0.1, 0.2, 0));
    moveTo(23, 20, 10);
    Pose pose = frame.motion().pose();
    Pose target = new Pose();
    frame.devicePose().multiply(inHand, target);
    Vec3 force = new Vec3();
    Vec3 torque = new Vec3();
    RigidCoupling.of(frame.shape(), STIFFNESS).compute(pose, target, force, torque);
    assertTrue(force.length() > 0.5, "the block presses the floor: " + force);
    Vec3 lever = pose.translation.sub(frame.devicePose().translation, new Vec3());
    Vec3 moment = lever.cross(force, new Vec3());
    assertTrue(moment.length() > 0.5, "beside the hand: " + moment);
    torque.add(moment, torque);
    assertEquals(0, device.lastForce().sub(force, new Vec3()).length(), 1e-6);
    assertEquals(0, device.lastTorque().sub(torque, new Vec3()).length(), 1e-5);
  }

  @Test
  void aMovableBodyGainsNoVoxelInTheEmptyPartOfItsGrid() {
    Body part = body("part", 8, 8, 4, 8, Mobility.MOVABLE, new Vec3(16, 16, 8));
    BodyScene scene = new BodyScene(List.of(floor, part));
    EditQueue queue = EditQueue.ofBodies(scene.grids());
    frame = newFrame(device, scene, queue, 10_000);
    hand.set(2, 2, 40);
    run(2);
    long solid = part.bits().solidCount();
    assertEquals(8 * 8 * 4, solid);
    assertTrue(queue.offer(new BrushEdit(1, new Vec3(4, 4, 4), 20, true)));
    run(5);
    assertEquals(solid, part.bits().solidCount());
    long ofFloor = floor.bits().solidCount();
    assertTrue(queue.offer(new BrushEdit(0, new Vec3(20, 20, 4), 3, false)));
    run(5);
    assertTrue(floor.bits().solidCount() < ofFloor);
    assertTrue(queue.offer(new BrushEdit(0, new Vec3(20, 20, 4), 3, true)));
    run(5);
    assertEquals(ofFloor, floor.bits().solidCount(), "a body that stands still gains voxels");
  }

  @Test
  void aFrameGivesItsDeviceItsSampleItsPosesAndItsWork() {
    run(1);
    RigidTool point = frame.shape();
    assertEquals(1, point.count());
    assertSame(device, frame.device());
    assertTrue(frame.sample().positionMm.sameBits(hand));
    assertFalse(frame.inContact());
    moveTo(20, 20, 15);
    assertTrue(frame.inContact());
    assertTrue(frame.devicePose().translation.sameBits(hand));
    hand.x += 0.1;
    run(1);
    assertTrue(frame.work() > 0);
    frame.requestTake();
    run(1);
    assertEquals(1, frame.heldBody());
    assertNotSame(point, frame.shape());
    assertTrue(frame.shape().count() > 100);
  }

  @Test
  void onlyTheToolIsWatchedAndNotTheBodyInHand() {
    NearestApproach nearest = new NearestApproach("floor", 1, floor.bits(), floor.grid(), 30);
    frame.watch(List.of(nearest));
    takeBlock();
    long frames = nearest.frame();
    double mm = nearest.nearestMm().orElseThrow();
    assertTrue(mm > 10 && mm < 12, "the point lies on the block: " + mm);
    moveTo(20, 20, 8);
    assertEquals(frames, nearest.frame());
    assertEquals(mm, nearest.nearestMm().orElseThrow());
  }

  /** Grey values make the floor softer, for the tool and for the body in hand. */
  @Test
  void greyValuesAlsoCountForTheBodyInHand() {
    double plain = pressBlockOnFloor();
    block.setPose(atRest());
    frame = newFrame(device, bodies, edits, 64);
    ScalarVolume values = ScalarVolume.of(floor.grid(), ScalarVolume.Storage.INT16);
    frame.use(new GreyMaterials(values, List.of(new GreyMaterials.Row(0, 0.25, 0, 0))));
    double soft = pressBlockOnFloor();
    assertEquals(0.25 * plain, soft, 0.05 * plain);
  }

  private static Pose atRest() {
    Pose pose = new Pose();
    pose.translation.set(16, 16, 8);
    return pose;
  }

  private double pressBlockOnFloor() {
    hand.set(20, 20, 20);
    run(1);
    takeBlock();
    moveTo(20, 20, 9);
    assertEquals(1, frame.heldBody());
    return device.lastForce().z;
  }

  @Test
  void skippedWorkIsCountedFromTheFirstFrameOn() {
    moveTo(20, 20, 15);
    long all = frame.statistics().skipped().values().stream().mapToLong(Long::longValue).sum();
    assertTrue(all > 0);
    assertTrue(frame.statistics().skipped().get("friction") > 0);
    assertTrue(all > frame.statistics().skipped().get("friction"), "rays, too");
  }
}
