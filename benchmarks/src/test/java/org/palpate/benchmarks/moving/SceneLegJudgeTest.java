package org.palpate.benchmarks.moving;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.benchmarks.stress.NaiveSegment;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.Ray;
import org.palpate.rigid.BodyMotions;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.RigidScene;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.ToolMotion;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** The solver moves a body among others that are far away; the judge sees one in its way. */
class SceneLegJudgeTest {
  private static final long SEED = Long.getLong("palpate.seed", 20_261_128);
  private static final double ROUNDING = 1e-7;
  private static final int MOTIONS = 120;

  private final SplittableRandom random = new SplittableRandom(SEED);
  private final RigidTool point = ToolSampler.point();
  private final RigidSettings settings = RigidSettings.of(100, Clearance.POINTS);

  private static Body corner(String name, Mobility mobility, double x) {
    BitCube bits = new BitCube(3, 3, 3);
    bits.set(1, 1, 1);
    bits.set(0, 1, 1);
    bits.set(1, 1, 2);
    Body body = new Body(name, bits, VoxelGrid.ofUnitVoxels(3, 3, 3), mobility);
    body.setPose(Pose.at(x, 0, 0));
    return body;
  }

  /** Returns a body of more voxels, and so of more sample points. */
  private static Body block(double x) {
    BitCube bits = new BitCube(4, 3, 3);
    for (int n = 0; n < 36; n++) {
      bits.set(n % 4, n / 4 % 3, n / 12);
    }
    bits.clear(1, 1, 2);
    Body body = new Body("block", bits, VoxelGrid.ofUnitVoxels(4, 3, 3), Mobility.MOVABLE);
    body.setPose(Pose.at(x, 0, 0));
    return body;
  }

  private Pose goal() {
    Pose pose = Pose.at(coordinate(), coordinate(), coordinate());
    pose.rotation.setRotationVector(new Vec3(coordinate() / 4, coordinate() / 4, coordinate() / 4));
    return pose;
  }

  private double coordinate() {
    return random.nextDouble(-2, 2);
  }

  @Test
  void countsTheLegsThatTouchAsAListOfSegmentsShowsThem() {
    long least = 0;
    long most = 0;
    long found = 0;
    long legs = 0;
    for (int n = 0; n < MOTIONS; n++) {
      Body unseen = corner("unseen", Mobility.MOVABLE, 0);
      Body mover = block(10);
      BodyScene known = new BodyScene(List.of(corner("far", Mobility.MOVABLE, -500), mover));
      MovableShapes shapes = MovableShapes.ofPoints(known);
      RigidSolver solver = new RigidSolver(new RigidScene(known, point, shapes, settings));
      ToolMotion motion = solver.newMotion();
      solver.place(Pose.at(0, 90, 0), motion);
      BodyScene seen = new BodyScene(List.of(unseen, mover));
      SceneLegJudge judge = new SceneLegJudge(seen, point, shapes);
      judge.begin(motion);
      long before = judge.legs();
      solver.bodies().setGoal(1, goal());
      solver.follow(Pose.at(0, 90, 0), motion);
      judge.judge(motion);
      BodyMotions moved = motion.bodies();
      RigidTool samples = shapes.shapes().get(0);
      assertEquals(1, moved.count());
      least += touching(samples, unseen, mover, moved.from(0), moved.to(0), -ROUNDING);
      most += touching(samples, unseen, mover, moved.from(0), moved.to(0), ROUNDING);
      found += judge.touching();
      legs += samples.count();
      assertEquals(samples.count() + 1L, judge.legs() - before, "and the tool against the mover");
      assertEquals(0, judge.broken());
    }
    assertEquals(least, most, "a leg is too close to call, choose another seed than " + SEED);
    assertEquals(least, found, "seed=" + SEED);
    assertTrue(least > 20 && least < legs * 3 / 4, least + " of " + legs);
  }

  /** Counts the samples of a body at rest whose path, seen from the mover, meets its voxels. */
  private static long touching(
      RigidTool samples, Body resting, Body mover, Pose from, Pose to, double margin) {
    Vec3 reference = samples.referenceMm(new Vec3());
    long count = 0;
    for (int n = 0; n < samples.count(); n++) {
      Vec3 p = samples.point(n, new Vec3()).add(reference, new Vec3());
      resting.pose().transform(p, p);
      Vec3 a = mover.grid().worldToGrid(from.inverseTransform(p, new Vec3()), new Vec3());
      Vec3 b = mover.grid().worldToGrid(to.inverseTransform(p, new Vec3()), new Vec3());
      Ray ray = new Ray().from(a.x, a.y, a.z).to(b.x, b.y, b.z);
      count += NaiveSegment.touches(mover.bits(), ray, margin) ? 1 : 0;
    }
    return count;
  }

  @Test
  void bodiesThatOverlapBeforeTheFirstFrameAreFound() {
    BodyScene apart =
        new BodyScene(List.of(corner("a", Mobility.FIXED, 0), corner("b", Mobility.MOVABLE, 3)));
    BodyScene overlapping =
        new BodyScene(List.of(corner("a", Mobility.FIXED, 0), corner("b", Mobility.MOVABLE, 0.5)));
    assertEquals(0, begun(apart, Pose.at(0, 90, 0)).touching());
    assertTrue(begun(overlapping, Pose.at(0, 90, 0)).touching() > 0);
    assertTrue(begun(apart, Pose.at(1.5, 1.5, 1.5)).touching() > 0, "the tool lies in the first");
    assertTrue(begun(apart, Pose.at(4.5, 1.5, 1.5)).touching() > 0, "the tool lies in the second");
  }

  private SceneLegJudge begun(BodyScene bodies, Pose tool) {
    ToolMotion motion = new ToolMotion(bodies.count());
    motion.pose().set(tool);
    SceneLegJudge judge = new SceneLegJudge(bodies, point, MovableShapes.ofPoints(bodies));
    judge.begin(motion);
    return judge;
  }

  @Test
  void bodiesOfWhichNoneCanMoveAreNotCompared() {
    BodyScene fixed =
        new BodyScene(List.of(corner("a", Mobility.FIXED, 0), corner("b", Mobility.FIXED, 0.5)));
    assertEquals(0, begun(fixed, Pose.at(0, 90, 0)).touching());
  }

  @Test
  void aBodyIsHeldFromWhereItLiesAndATakeFromElsewhereBreaksTheChain() {
    BodyScene bodies = new BodyScene(List.of(corner("body", Mobility.MOVABLE, 10)));
    MovableShapes shapes = MovableShapes.ofPoints(bodies);
    RigidSolver solver = new RigidSolver(new RigidScene(bodies, point, shapes, settings));
    ToolMotion motion = solver.newMotion();
    solver.place(Pose.at(0, 90, 0), motion);
    SceneLegJudge judge = new SceneLegJudge(bodies, point, shapes);
    judge.begin(motion);
    RigidSolver held = solver.ofBody(0);
    held.takeOver(motion);
    judge.take(0, motion);
    Pose hand = new Pose().set(motion.pose());
    hand.translation.x += 2;
    held.follow(hand, motion);
    judge.judge(motion);
    assertEquals(0, judge.broken());
    motion.pose().translation.x += 0x1p-20;
    judge.take(0, motion);
    assertEquals(1, judge.broken(), "not where the body lies");
  }

  @Test
  void aToolThatIsPlacedInABodyWhenTheHandLetsGoIsFound() {
    BodyScene bodies = new BodyScene(List.of(corner("body", Mobility.MOVABLE, 10)));
    SceneLegJudge judge = begun(bodies, Pose.at(0, 90, 0));
    ToolMotion placed = new ToolMotion(1);
    placed.pose().set(Pose.at(5, 5, 5));
    judge.letGo(placed);
    assertEquals(0, judge.touching());
    placed.pose().set(Pose.at(11.5, 1.5, 1.5));
    judge.letGo(placed);
    assertEquals(1, judge.touching());
  }
}
