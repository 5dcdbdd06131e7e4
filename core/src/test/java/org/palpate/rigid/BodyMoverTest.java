package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.body.RandomSolids;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

class BodyMoverTest {
  private static final double MAX_STEP_MM = 4;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private ToolMotion motion;
  private int framesThatWaited;

  /** Returns a body of unit voxels whose middle lies at x, y, z at rest. */
  private static Body body(String name, BitCube bits, Mobility mobility, double x) {
    Body body =
        new Body(
            name, bits, VoxelGrid.ofUnitVoxels(bits.sizeX(), bits.sizeY(), bits.sizeZ()), mobility);
    body.setPose(Pose.at(x, 0, 0));
    return body;
  }

  private static Body block(String name, Mobility mobility, double x) {
    return body(name, ToolScenes.block(8, 8, 8), mobility, x);
  }

  private static RigidSolver solver(BodyScene scene, RigidTool tool, boolean whole, boolean skips) {
    MovableShapes shapes =
        whole ? MovableShapes.ofWholeBodies(scene, 0) : MovableShapes.ofPoints(scene);
    RigidSettings settings =
        whole
            ? RigidSettings.ofWholeBodies(MAX_STEP_MM, scene, tool)
            : RigidSettings.of(MAX_STEP_MM, Clearance.POINTS);
    RigidSettings chosen = new RigidSettings(MAX_STEP_MM, settings.clearances(), List.of(), skips);
    return new RigidSolver(new RigidScene(scene, tool, shapes, chosen));
  }

  private RigidSolver placed(BodyScene scene, RigidTool tool, Pose device) {
    RigidSolver solver = solver(scene, tool, true, true);
    motion = solver.newMotion();
    assertTrue(solver.place(device, motion));
    return solver;
  }

  private void follow(RigidSolver solver, Pose device, int frames) {
    for (int frame = 0; frame < frames; frame++) {
      solver.follow(device, motion);
    }
  }

  @Test
  void aBodyReachesItsGoalBitForBitByStepsOfAtMostTheLongestStep() {
    BodyScene scene = new BodyScene(List.of(block("block", Mobility.MOVABLE, 0)));
    RigidSolver solver = placed(scene, ToolSampler.point(), Pose.at(0, 0, 90));
    Pose goal = new Pose();
    goal.rotation.setRotationVector(new Vec3(0.3, -0.5, 1));
    goal.translation.set(40, 0.1, -7.25);
    solver.bodies().setGoal(0, goal);
    int frames = 0;
    Pose before = new Pose();
    Vec3 corner = new Vec3();
    while (solver.bodies().hasWork()) {
      before.set(scene.body(0).pose());
      solver.follow(Pose.at(0, 0, 90), motion);
      before.transform(corner.set(8, 8, 8), corner);
      Vec3 after = scene.body(0).pose().transform(new Vec3(8, 8, 8), new Vec3());
      assertTrue(after.sub(corner, corner).length() <= MAX_STEP_MM);
      assertTrue(++frames < 100);
    }
    assertTrue(frames >= 40 / MAX_STEP_MM);
    assertTrue(scene.body(0).pose().sameBits(ReferencePose.snap(goal)));
    assertEquals(0, solver.bodies().heldBack());
  }

  @Test
  void aBodyThatRunsIntoAnotherIsHeldBackAndGoesOnOnceTheWayIsFree() {
    BodyScene scene =
        new BodyScene(
            List.of(block("first", Mobility.MOVABLE, 0), block("second", Mobility.MOVABLE, 20)));
    RigidSolver solver = placed(scene, ToolSampler.point(), Pose.at(0, 0, 90));
    solver.bodies().setGoal(0, Pose.at(40, 0, 0));
    follow(solver, Pose.at(0, 0, 90), 50);
    double x = scene.body(0).pose().translation.x;
    assertTrue(x < 12 && x > 10, "stopped before the second: " + x);
    assertTrue(solver.bodies().heldBack() > 20);
    solver.bodies().setGoal(1, Pose.at(20, 30, 0));
    follow(solver, Pose.at(0, 0, 90), 50);
    assertEquals(40, scene.body(0).pose().translation.x);
  }

  @Test
  void aVoxelThatIsAddedInTheWayHoldsABodyBackAtOnce() {
    Body block = block("block", Mobility.MOVABLE, 0);
    BitCube bits = new BitCube(20, 8, 8);
    bits.set(19, 7, 7);
    Body other = body("other", bits, Mobility.FIXED, 20);
    BodyScene scene = new BodyScene(List.of(block, other));
    RigidSolver solver = placed(scene, ToolSampler.point(), Pose.at(0, 0, 90));
    solver.bodies().setGoal(0, Pose.at(0.5, 0, 0));
    follow(solver, Pose.at(0, 0, 90), 5);
    assertEquals(0.5, block.pose().translation.x);
    bits.set(0, 3, 3); // from x = 20 to 21
    IntBox changed = new IntBox();
    changed.include(0, 3, 3);
    other.voxelsChanged(changed);
    solver.bodies().setGoal(0, Pose.at(25, 0, 0));
    follow(solver, Pose.at(0, 0, 90), 50);
    assertTrue(block.pose().translation.x < 12, "stopped at " + block.pose());
  }

  @Test
  void aBodyPushesTheToolWhichReturnsToItsDeviceWhenTheBodyLeaves() {
    BodyScene scene = new BodyScene(List.of(block("block", Mobility.MOVABLE, 0)));
    RigidTool ball = ToolSampler.ofShape(RodShape.sphere(2), 0.4);
    Pose device = Pose.at(12, 4, 4);
    RigidSolver solver = placed(scene, ball, device);
    solver.bodies().setGoal(0, Pose.at(6, 0, 0));
    follow(solver, device, 60);
    assertEquals(6, scene.body(0).pose().translation.x);
    assertTrue(solver.bodies().pushes() > 0);
    assertTrue(motion.pose().translation.x > 15.9, "pushed: " + motion.pose());
    assertTrue(motion.contact());
    solver.bodies().setGoal(0, Pose.at(-10, 0, 0));
    follow(solver, device, 60);
    assertTrue(motion.pose().sameBits(device));
  }

  @Test
  void aToolIsNotPushedFartherFromItsDeviceThanTheLimit() {
    BodyScene scene = new BodyScene(List.of(block("block", Mobility.MOVABLE, 0)));
    RigidTool ball = ToolSampler.ofShape(RodShape.sphere(2), 0.4);
    Pose device = Pose.at(12, 4, 4);
    RigidSolver solver = placed(scene, ball, device);
    solver.bodies().setGoal(0, Pose.at(60, 0, 0));
    follow(solver, device, 200);
    double pushed = motion.pose().translation.x - 12;
    assertTrue(pushed > 10 && pushed <= BodyMover.FARTHEST_PUSH_EDGES, "pushed by " + pushed);
    assertTrue(solver.bodies().heldBack() > 50);
  }

  @Test
  void aPinchedToolHoldsTheBodyBack() {
    BodyScene scene =
        new BodyScene(
            List.of(block("block", Mobility.MOVABLE, 0), block("wall", Mobility.FIXED, 20)));
    RigidTool ball = ToolSampler.ofShape(RodShape.sphere(2), 0.4);
    Pose device = Pose.at(14, 4, 4);
    RigidSolver solver = placed(scene, ball, device);
    solver.bodies().setGoal(0, Pose.at(12, 0, 0));
    follow(solver, device, 100);
    double gap = 20 - 8 - scene.body(0).pose().translation.x;
    assertTrue(gap >= 4 && gap < 5.5, "gap for a ball of 4 mm: " + gap);
    assertTrue(solver.bodies().heldBack() > 20);
  }

  @Test
  void withoutANewDevicePoseBodiesMoveAndPushAllTheSame() {
    BodyScene scene = new BodyScene(List.of(block("block", Mobility.MOVABLE, 0)));
    RigidTool ball = ToolSampler.ofShape(RodShape.sphere(2), 0.4);
    RigidSolver solver = placed(scene, ball, Pose.at(12, 4, 4));
    follow(solver, Pose.at(12, 4, 4), 1);
    solver.bodies().setGoal(0, Pose.at(6, 0, 0));
    for (int frame = 0; frame < 30; frame++) {
      solver.rest(motion);
    }
    assertEquals(6, scene.body(0).pose().translation.x);
    assertTrue(solver.bodies().pushes() > 0);
  }

  @Test
  void theBodyWithFewerPointsCarriesThemWhoeverMoves() {
    Body large = block("large", Mobility.MOVABLE, 0);
    Body small = body("small", ToolScenes.block(3, 3, 3), Mobility.MOVABLE, 20);
    BodyScene scene = new BodyScene(List.of(large, small));
    RigidScene rigid =
        new RigidScene(
            scene,
            ToolSampler.point(),
            MovableShapes.ofPoints(scene),
            RigidSettings.of(1, Clearance.POINTS));
    BodyVerifier pair = rigid.verifier(0).pair(1);
    assertSame(pair, rigid.verifier(1).pair(0));
    assertSame(small, pair.points.body);
    assertSame(large, pair.solid.body);
    assertEquals(-1, rigid.verifier(0).pushSign(1));
    assertEquals(1, rigid.verifier(1).pushSign(0));
  }

  @Test
  void bodiesThatOverlapAtTheStartAreRefused() {
    BodyScene scene =
        new BodyScene(
            List.of(block("first", Mobility.MOVABLE, 0), block("second", Mobility.FIXED, 7)));
    Exception refused =
        assertThrows(
            IllegalArgumentException.class, () -> solver(scene, ToolSampler.point(), false, true));
    assertTrue(refused.getMessage().contains("first and second overlap"), refused.getMessage());
  }

  @Test
  void goalsOfBodiesThatStandStillAndGoalsThatAreNoPosesAreRefused() {
    BodyScene scene =
        new BodyScene(
            List.of(block("first", Mobility.MOVABLE, 0), block("second", Mobility.FIXED, 20)));
    BodyMover bodies = solver(scene, ToolSampler.point(), false, true).bodies();
    assertThrows(IllegalArgumentException.class, () -> bodies.setGoal(1, new Pose()));
    assertThrows(
        IllegalArgumentException.class, () -> bodies.setGoal(0, Pose.at(Double.NaN, 0, 0)));
    Pose twice = new Pose();
    twice.rotation.set(2, 0, 0, 0);
    assertThrows(IllegalArgumentException.class, () -> bodies.setGoal(0, twice));
    assertFalse(bodies.hasWork());
  }

  @Test
  void framesAreTheSameToTheBitWithoutSkips() {
    for (int round = 0; round < 6; round++) {
      long seed = random.nextLong();
      boolean whole = round % 2 == 0;
      assertEquals(run(seed, whole, true), run(seed, whole, false), "seed " + seed);
    }
  }

  /** Returns all poses of a run, as text. */
  private static List<String> run(long seed, boolean whole, boolean skips) {
    SplittableRandom random = new SplittableRandom(seed);
    BodyScene scene = clutter(random.nextLong());
    RigidTool tool = ToolSampler.ofShape(RodShape.capsule(1, 4), 0.5);
    RigidSolver solver = solver(scene, tool, whole, skips);
    ToolMotion motion = solver.newMotion();
    HostilePoses device = new HostilePoses(random, 20);
    solver.place(Pose.at(0, 0, 40), motion);
    List<String> poses = new ArrayList<>();
    for (int frame = 0; frame < 400; frame++) {
      if (frame % 10 == 0) {
        solver.bodies().setGoal(random.nextInt(3), RandomGeometry.pose(random, 15));
      }
      solver.follow(device.next(), motion);
      poses.add(motion.pose() + " " + scene.body(frame % 3).pose() + " " + solver.work());
    }
    return poses;
  }

  @Test
  void posesAsCommittedReplayAsGoalsToTheSameBits() {
    for (int round = 0; round < 6; round++) {
      long seed = random.nextLong();
      List<Pose> committed = new ArrayList<>();
      List<String> recorded = record(seed, clutter(seed), 500, committed, false);
      List<String> replayed = record(seed, clutter(seed), 500, committed, true);
      assertEquals(recorded, replayed, "seed " + seed);
    }
  }

  @Test
  void posesReplayToTheSameBitsAlthoughBodiesHadToWait() {
    long seed = random.nextLong();
    List<Pose> committed = new ArrayList<>();
    List<String> recorded = record(seed, crowd(), 100, committed, false);
    assertTrue(framesThatWaited > 10, "waited in " + framesThatWaited + " frames");
    assertEquals(recorded, record(seed, crowd(), 100, committed, true), "seed " + seed);
  }

  /**
   * Runs bodies after random goals and appends the pose of each body after each frame, or after
   * recorded poses. Returns the tool's poses.
   */
  private List<String> record(
      long seed, BodyScene scene, int frames, List<Pose> committed, boolean replays) {
    SplittableRandom random = new SplittableRandom(seed);
    int count = scene.count();
    RigidSolver solver =
        solver(scene, ToolSampler.ofShape(RodShape.capsule(1, 4), 0.5), true, true);
    ToolMotion motion = solver.newMotion();
    solver.place(Pose.at(0, 0, 40), motion);
    Pose device = Pose.at(0, 0, 40);
    List<String> poses = new ArrayList<>();
    for (int frame = 0; frame < frames; frame++) {
      for (int n = 0; n < count; n++) {
        Pose goal = RandomGeometry.pose(random, 12);
        if (replays) {
          solver.bodies().setGoal(n, committed.get(count * frame + n));
        } else if ((frame + n) % 10 == 0) {
          solver.bodies().setGoal(n, goal);
        }
      }
      device.translation.set(10 * Math.sin(0.01 * frame), 5, 10 * Math.cos(0.013 * frame));
      solver.follow(device, motion);
      for (int n = 1; n < motion.bodies().count(); n++) {
        assertTrue(motion.bodies().body(n) > motion.bodies().body(n - 1), "order of indices");
      }
      framesThatWaited += solver.bodies().work() >= BodyMover.MOST_WORK ? 1 : 0;
      poses.add(motion.pose().toString());
      for (int n = 0; n < count; n++) {
        poses.add(scene.body(n).pose().toString());
        if (!replays) {
          committed.add(new Pose().set(scene.body(n).pose()));
        }
      }
    }
    return poses;
  }

  private static BodyScene clutter(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    List<Body> bodies = new ArrayList<>();
    for (int n = 0; n < 3; n++) {
      BitCube bits = RandomSolids.clutter(random, 9, 8, 7);
      bodies.add(body("body" + n, bits, Mobility.MOVABLE, 20 * n));
    }
    return new BodyScene(bodies);
  }

  @Test
  void theWorkOfAFrameIsBoundedOverAllBodiesAndTheOthersMoveInTheNextFrames() {
    BodyScene scene = crowd();
    BodyScene again = crowd();
    RigidSolver quick = solver(scene, ToolSampler.point(), false, true);
    RigidSolver slow = solver(again, ToolSampler.point(), false, false);
    motion = quick.newMotion();
    ToolMotion slowMotion = slow.newMotion();
    quick.place(Pose.at(0, 0, 90), motion);
    slow.place(Pose.at(0, 0, 90), slowMotion);
    Pose goal = new Pose();
    for (int n = 0; n < scene.count(); n++) {
      goal.set(scene.body(n).pose());
      goal.translation.x += 0.25;
      quick.bodies().setGoal(n, goal);
      slow.bodies().setGoal(n, goal);
    }
    int next = 0;
    long all = 0;
    while (quick.bodies().hasWork()) {
      quick.rest(motion);
      slow.rest(slowMotion);
      long work = quick.bodies().work();
      assertEquals(slow.bodies().work(), work, "counted as if nothing were skipped");
      assertTrue(work < BodyMover.MOST_WORK + 2_000, "work " + work);
      assertTrue(work >= BodyMover.MOST_WORK || !quick.bodies().hasWork(), "waits in vain");
      assertTrue(motion.bodies().count() > 0);
      for (int n = 0; n < motion.bodies().count(); n++) {
        assertEquals(next++, motion.bodies().body(n), "in the order of their indices");
      }
      all += work;
    }
    assertEquals(scene.count(), next, "each has moved once");
    assertTrue(all > 2 * BodyMover.MOST_WORK, "work of all bodies " + all);
    assertEquals(0, quick.bodies().heldBack(), "a body that waits is not held back");
  }

  /** Returns a square of blocks with half a voxel between two of them. */
  private static BodyScene crowd() {
    List<Body> bodies = new ArrayList<>();
    for (int n = 0; n < 25; n++) {
      Body block = block("block" + n, Mobility.MOVABLE, 0);
      block.setPose(Pose.at(8.5 * (4 - n / 5), 8.5 * (n % 5), 0));
      bodies.add(block);
    }
    return new BodyScene(bodies);
  }

  @Test
  void warmFramesOfMovingAndHeldBodiesAllocateNothing() {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    BodyScene scene = clutter(random.nextLong());
    RigidTool tool = ToolSampler.ofShape(RodShape.capsule(1, 4), 0.5);
    RigidSolver solver = placed(scene, tool, Pose.at(0, 0, 40));
    RigidSolver held = solver.ofBody(1);
    Pose[] goals = new Pose[100];
    for (int n = 0; n < goals.length; n++) {
      goals[n] = RandomGeometry.pose(random, 15);
    }
    Pose device = Pose.at(0, 0, 0);
    List<Long> allocated = new ArrayList<>();
    while (allocated.size() < 8
        && (allocated.isEmpty() || allocated.get(allocated.size() - 1) > 0)) {
      long before = threads.getCurrentThreadAllocatedBytes();
      for (int frame = 0; frame < 5_000; frame++) {
        solver.bodies().setGoal(frame % 3, goals[frame / 20 % goals.length]);
        device.translation.set(frame % 30, frame % 7, frame % 11);
        if (frame % 300 == 200) {
          held.takeOver(motion);
        } else if (frame % 300 == 0) {
          solver.place(device, motion);
        }
        (frame % 300 < 200 ? solver : held).follow(device, motion);
      }
      allocated.add(threads.getCurrentThreadAllocatedBytes() - before);
    }
    assertTrue(solver.bodies().pushes() > 0 && solver.bodies().heldBack() > 0);
    assertEquals(0, allocated.get(allocated.size() - 1), "bytes by rounds: " + allocated);
  }
}
