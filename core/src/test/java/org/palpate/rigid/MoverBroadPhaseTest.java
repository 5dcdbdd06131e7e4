package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** Compares frames with the broad phase with a loop over all bodies, and judges their legs. */
class MoverBroadPhaseTest {
  private static final double MAX_STEP_MM = 6;
  private static final double APART_MM = 26;
  private static final RigidTool TOOL = ToolSampler.ofShape(RodShape.capsule(1, 4), 0.5);

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  /** Returns clutter on a lattice, at odd rotations and spacings; every fifth body stands still. */
  private static BodyScene bodies(SplittableRandom random, int count) {
    List<Body> bodies = new ArrayList<>();
    for (int n = 0; n < count; n++) {
      BitCube bits =
          RandomSolids.clutter(
              random, random.nextInt(4, 9), random.nextInt(4, 9), random.nextInt(4, 9));
      Vec3 spacing = n % 3 == 0 ? new Vec3(1, 0.8, 1.4) : new Vec3(1, 1, 1);
      VoxelGrid grid = ToolScenes.obliqueGrid(bits, spacing);
      Mobility mobility = n % 5 == 4 ? Mobility.FIXED : Mobility.MOVABLE;
      Body body = new Body("body" + n, bits, grid, mobility);
      Vec3 middle = new Vec3(4, 4, 4);
      grid.gridToWorld(middle, middle);
      Pose pose = RandomGeometry.pose(random, 1);
      pose.rotation.rotate(middle, middle);
      Vec3 place =
          new Vec3(APART_MM * (n % 3), APART_MM * (n / 3 % 3), APART_MM * Math.floor(n / 9.0));
      place.sub(middle, middle).add(pose.translation, pose.translation);
      body.setPose(pose);
      bodies.add(body);
    }
    return new BodyScene(bodies);
  }

  private static RigidScene scene(BodyScene bodies, boolean whole, boolean skips) {
    MovableShapes shapes =
        whole ? MovableShapes.ofWholeBodies(bodies, 0) : MovableShapes.ofPoints(bodies);
    RigidSettings settings =
        whole
            ? RigidSettings.ofWholeBodies(MAX_STEP_MM, bodies, TOOL)
            : RigidSettings.of(MAX_STEP_MM, Clearance.POINTS);
    return new RigidScene(
        bodies,
        TOOL,
        shapes,
        new RigidSettings(MAX_STEP_MM, settings.clearances(), List.of(), skips));
  }

  @Test
  void posesAndWorkAreTheSameToTheBitAsThoseOfALoopOverAllBodies() {
    long moves = 0;
    for (int round = 0; round < 6; round++) {
      long seed = random.nextLong();
      boolean whole = round % 2 == 0;
      int count = 5 + 4 * round;
      List<String> poses = run(seed, count, whole, true);
      assertEquals(run(seed, count, whole, false), poses, "seed " + seed);
      moves += poses.stream().distinct().count();
    }
    assertTrue(moves > 1_000, moves + " different poses");
  }

  /**
   * Returns all poses and the work of a run, as text: the hand holds the tool, bodies or groups.
   */
  private static List<String> run(long seed, int count, boolean whole, boolean skips) {
    SplittableRandom random = new SplittableRandom(seed);
    BodyScene bodies = bodies(random, count);
    RigidSolver solver = new RigidSolver(scene(bodies, whole, skips));
    ToolMotion motion = solver.newMotion();
    HostilePoses device = new HostilePoses(random, 60);
    solver.place(device.lastPose(), motion);
    RigidSolver hand = solver;
    List<String> all = new ArrayList<>();
    for (int frame = 0; frame < 240; frame++) {
      if (frame % 40 == 20) {
        int held = random.nextInt(4);
        hand = solver.ofBody(held);
        hand.takeOver(motion);
        if (frame % 80 == 20) {
          hand.carry((held + 1) % 4);
        }
      } else if (frame % 40 == 0) {
        hand.carryNone();
        hand = solver;
        spoil(bodies, random, frame);
        solver.place(device.lastPose(), motion);
      }
      if (frame % 5 == 0) {
        solver.bodies().setGoal(random.nextInt(4), RandomGeometry.pose(random, 40));
      }
      hand.follow(device.next(), motion);
      all.add(motion.pose() + " " + bodies.poses() + " " + hand.work());
    }
    return all;
  }

  /** Edits a body that stands still, or moves one without verification, as undo does. */
  private static void spoil(BodyScene bodies, SplittableRandom random, int frame) {
    if (frame % 80 == 0) {
      Body fixed = bodies.body(4);
      IntBox box = new IntBox();
      int last = fixed.bits().sizeX() - 1;
      fixed.bits().set(last, 0, 0);
      box.include(last, 0, 0);
      fixed.voxelsChanged(box);
    } else {
      Pose far = new Pose().set(bodies.body(1).pose());
      far.translation.add(RandomGeometry.vector(random, 300), far.translation);
      bodies.body(1).setPose(ReferencePose.snap(far));
    }
  }

  @Test
  void whatIsNotFoundIsTouchedByNoLegEvenIfABodyTurnsFar() {
    int apart = 0;
    for (int round = 0; round < 40; round++) {
      RigidScene scene = scene(bodies(random, 6), round % 2 == 0, false);
      MoverVerifier mover = scene.verifier(round % 4);
      for (int n = 0; n < 60; n++) {
        Pose goal = new Pose().set(mover.pose());
        double size = Math.pow(10, random.nextDouble(-3, 2));
        goal.displace(
            RandomGeometry.vector(random, size),
            RandomGeometry.vector(random, random.nextDouble(2)),
            1,
            new Quaternion(),
            goal);
        mover.propose(ReferencePose.snap(goal));
        for (int other = 0; other < 6; other++) {
          BodyVerifier pair = mover.pair(other);
          if (pair != null && !mover.isFound(other)) {
            assertTrue(pair.isFree(null, true, new LegHits()), "body " + other + " by " + goal);
            apart++;
          }
        }
      }
    }
    assertTrue(apart > 1_000, apart + " pairs were not found");
  }

  @Test
  void theSamplePointsOfABodyThatWasCutAwayAreFound() {
    Body rod = movable("rod", ToolScenes.block(40, 2, 2), 0, 0);
    Body block = movable("block", ToolScenes.block(12, 12, 12), 34, 20);
    RigidScene scene = scene(new BodyScene(List.of(rod, block)), false, true);
    MoverVerifier mover = scene.verifier(1);
    assertSame(mover.pair(0).points.body, rod, "which has fewer sample points");
    IntBox box = new IntBox().set(rod.bits().bounds());
    for (int n = 1; n < 40 * 2 * 2; n++) {
      rod.bits().clear(n % 40, n / 40 % 2, n / 80);
    }
    rod.voxelsChanged(box);
    mover.takeEdits();
    Pose goal = new Pose().set(mover.pose());
    goal.translation.y -= 40;
    mover.propose(ReferencePose.snap(goal));
    assertFalse(mover.isFree(0, 0, true, new LegHits()));
  }

  private static Body movable(String name, BitCube bits, double x, double y) {
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(bits.sizeX(), bits.sizeY(), bits.sizeZ());
    Body body = new Body(name, bits, grid, Mobility.MOVABLE);
    Pose pose = new Pose();
    pose.translation.set(x, y, 0);
    body.setPose(pose);
    return body;
  }

  /** Grown cells reach 3 mm beyond the grid, whose axes are unit vectors only to some digits. */
  @Test
  void aPointThatReachesGrownCellsBeyondADistortedGridIsFound() {
    Vec3 shortAxis = new Vec3(1 - 9e-5, 0, 0);
    RigidTransform axes =
        new RigidTransform(shortAxis, new Vec3(0, 1, 0), new Vec3(0, 0, 1), new Vec3());
    VoxelGrid grid = new VoxelGrid(10, 1, 1, new Vec3(1, 1, 1), axes);
    Body rod = new Body("rod", ToolScenes.block(10, 1, 1), grid, Mobility.FIXED);
    Clearance[] clearance = {new Clearance(3, 3, 0)};
    MoverVerifier verifier =
        ToolScenes.verifier(new BodyScene(List.of(rod)), ToolSampler.point(), clearance, true);
    Pose pose = new Pose();
    pose.translation.set(13.3, 0.5, 0.5);
    assertTrue(verifier.place(pose, true));
    pose.translation.x = 13.0011; // 12.99993 in the grid, where the cells end at 13
    verifier.propose(pose);
    assertFalse(verifier.isFree(0, 0, true, new LegHits()));
  }

  @Test
  void farBodiesCostNoVerification() {
    BodyScene bodies = bodies(random, 60);
    RigidScene scene = scene(bodies, false, true);
    MoverVerifier mover = scene.verifier(0);
    Pose goal = new Pose().set(mover.pose());
    goal.translation.x += 1;
    mover.propose(ReferencePose.snap(goal));
    int found = 0;
    for (int other = 0; other < 60; other++) {
      found += mover.isFound(other) ? 1 : 0;
    }
    assertTrue(found <= 8, "found " + found + " of 60");
  }

  @Test
  void theJudgeCatchesABoxThatIsNotRefitted() {
    BodyScene bodies = blocks();
    RigidScene scene = scene(bodies, false, true);
    assertNull(faultOfPushInto(bodies, scene), "the broad phase follows the body");
    BodyScene again = blocks();
    RigidScene broken = scene(again, false, true);
    Mover moved = broken.verifier(1).mover;
    Mover[] decoy = {moved};
    new MoverBroadPhase(decoy, new int[1], 1, true); // takes the motions instead
    assertNotNull(faultOfPushInto(again, broken));
  }

  private static BodyScene blocks() {
    List<Body> bodies = new ArrayList<>();
    for (int n = 0; n < 2; n++) {
      bodies.add(movable("block" + n, ToolScenes.block(6, 6, 6), 60.0 * n, 0));
    }
    return new BodyScene(bodies);
  }

  /** Moves the second block to (20, 0, 0), and the tool through it; returns a fault of the legs. */
  private static String faultOfPushInto(BodyScene bodies, RigidScene scene) {
    RigidSolver solver = new RigidSolver(scene);
    ToolMotion motion = solver.newMotion();
    Pose device = new Pose();
    device.translation.set(23, 3, 20);
    assertTrue(solver.place(device, motion));
    Pose goal = new Pose();
    goal.translation.set(20, 0, 0);
    solver.bodies().setGoal(1, goal);
    while (solver.bodies().hasWork()) {
      solver.rest(motion);
    }
    assertTrue(bodies.body(1).pose().sameBits(goal));
    ToolLegJudge judge = new ToolLegJudge(bodies, TOOL);
    assertNull(judge.begin(motion));
    device.translation.z = -20;
    String fault = null;
    for (int frame = 0; frame < 50 && fault == null; frame++) {
      solver.follow(device, motion);
      fault = judge.fault(motion);
    }
    return fault;
  }
}
