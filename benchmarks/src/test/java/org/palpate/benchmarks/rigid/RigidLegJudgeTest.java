package org.palpate.benchmarks.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.benchmarks.stress.NaiveSegment;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.Ray;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** A solver that sees empty bodies moves a tool; the judge sees the same bodies with solids. */
class RigidLegJudgeTest {
  private static final long SEED = Long.getLong("palpate.seed", 20_261_128);

  /** Far above the rounding of the maps to the grid, far below the tool's motion, voxels. */
  private static final double ROUNDING = 1e-9;

  private final SplittableRandom random = new SplittableRandom(SEED);
  private final RigidTool tool = ToolSampler.ofShape(new BoxShape(2, 1, 1), 0.8);

  private Body body(boolean solid, Pose pose) {
    BitCube bits = new BitCube(4, 4, 3);
    if (solid) {
      bits.set(1, 1, 1);
      bits.set(3, 0, 2);
      bits.set(0, 3, 0);
    }
    VoxelGrid grid = new VoxelGrid(4, 4, 3, new Vec3(0.8, 1, 1.5), RigidTransform.identity());
    Body body = new Body("body", bits, grid, Mobility.FIXED);
    body.setPose(pose);
    return body;
  }

  private Pose pose(double reachMm) {
    Pose pose = Pose.at(coordinate(reachMm), coordinate(reachMm), coordinate(reachMm));
    pose.rotation.setRotationVector(new Vec3(coordinate(2), coordinate(2), coordinate(2)));
    return pose;
  }

  private double coordinate(double reach) {
    return random.nextDouble(-reach, reach);
  }

  @Test
  void countsTheLegsThatTouchAsAListOfSegmentsShowsThem() {
    List<Pose> places = List.of(pose(3), pose(3));
    List<Body> unseen = new ArrayList<>();
    List<Body> solids = new ArrayList<>();
    for (Pose place : places) {
      unseen.add(body(false, place));
      solids.add(body(true, place));
    }
    BodyScene scene = new BodyScene(solids);
    ToolRun run = new ToolRun(new BodyScene(unseen), tool, ToolClearance.POINTS);
    run.start(pose(4));
    RigidLegJudge judge = new RigidLegJudge(100);
    judge.begin(run.motion);
    long least = 0;
    long most = 0;
    long legs = 0;
    for (int frame = 0; frame < 400; frame++) {
      run.follow(pose(3));
      judge.judge(scene, tool, run.motion);
      for (int step = 0; step < run.motion.steps(); step++) {
        Pose from = run.motion.pathPose(step);
        Pose to = run.motion.pathPose(step + 1);
        least += touching(scene, from, to, -ROUNDING);
        most += touching(scene, from, to, ROUNDING);
        legs += 2L * tool.count();
      }
    }
    assertEquals(least, most, "a leg is too close to call, choose another seed than " + SEED);
    assertEquals(least, judge.touching(), "seed=" + SEED);
    assertEquals(legs, judge.legs());
    assertTrue(least > 50 && least < legs / 2, least + " of " + legs);
    assertEquals(0, judge.broken());
    assertEquals(100, judge.compared());
    assertEquals(0, judge.disagreements());
  }

  private long touching(BodyScene bodies, Pose from, Pose to, double margin) {
    long count = 0;
    for (int n = 0; n < bodies.count(); n++) {
      for (int point = 0; point < tool.count(); point++) {
        Vec3 a = toGrid(bodies.body(n), from, point);
        Vec3 b = toGrid(bodies.body(n), to, point);
        Ray ray = new Ray().from(a.x, a.y, a.z).to(b.x, b.y, b.z);
        count += NaiveSegment.touches(bodies.body(n).bits(), ray, margin) ? 1 : 0;
      }
    }
    return count;
  }

  private Vec3 toGrid(Body body, Pose pose, int point) {
    Vec3 p = pose.transform(tool.point(point, new Vec3()), new Vec3());
    body.pose().inverseTransform(p, p);
    return body.grid().worldToGrid(p, p);
  }

  @Test
  void aToolThatRestsHasNoLegsAndAnUnbrokenChain() {
    BodyScene empty = new BodyScene(List.of(body(false, new Pose())));
    ToolRun run = new ToolRun(empty, tool, ToolClearance.POINTS);
    run.start(Pose.at(5, 5, 5));
    RigidLegJudge judge = new RigidLegJudge(0);
    judge.begin(run.motion);
    for (int frame = 0; frame < 3; frame++) {
      run.follow(Pose.at(5, 5, 5));
      judge.judge(empty, tool, run.motion);
    }
    assertEquals(List.of(0L, 0L), List.of(judge.legs(), judge.broken()));
  }

  @Test
  void everyFrameThatWasNotJudgedBreaksTheChainOnce() {
    BodyScene empty = new BodyScene(List.of(body(false, new Pose())));
    ToolRun run = new ToolRun(empty, tool, ToolClearance.POINTS);
    run.start(Pose.at(5, 5, 5));
    RigidLegJudge judge = new RigidLegJudge(0);
    judge.begin(run.motion);
    for (int frame = 1; frame <= 9; frame++) {
      run.follow(Pose.at(5 + frame, 5, 5));
      if (frame % 3 != 0) {
        judge.judge(empty, tool, run.motion);
      }
    }
    assertEquals(2, judge.broken(), "after the third and the sixth frame");
  }

  @Test
  void aPoseThatDiffersInOneBitBreaksTheChainAndANewBeginningMendsIt() {
    BodyScene empty = new BodyScene(List.of(body(false, new Pose())));
    ToolRun run = new ToolRun(empty, tool, ToolClearance.POINTS);
    run.start(Pose.at(5, 5, 5));
    RigidLegJudge judge = new RigidLegJudge(0);
    Pose other = Pose.at(5, Math.nextUp(5.0), 5);
    judge.begin(other);
    run.follow(Pose.at(6, 5, 5));
    judge.judge(empty, tool, run.motion);
    assertEquals(1, judge.broken());
    judge.begin(run.motion.pose());
    run.follow(Pose.at(7, 5, 5));
    judge.judge(empty, tool, run.motion);
    assertEquals(1, judge.broken());
    assertEquals(2L * tool.count(), judge.legs());
  }
}
