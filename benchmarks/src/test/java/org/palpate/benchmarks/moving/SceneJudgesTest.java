package org.palpate.benchmarks.moving;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
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

class SceneJudgesTest {
  private static final RigidSettings SETTINGS = RigidSettings.of(100, Clearance.POINTS);

  private final RigidTool point = ToolSampler.point();
  private final Body dot = dot("dot", 10);
  private final BodyScene bodies = new BodyScene(List.of(dot));
  private final MovableShapes shapes = MovableShapes.ofPoints(bodies);
  private final RigidSolver solver =
      new RigidSolver(new RigidScene(bodies, point, shapes, SETTINGS));
  private final ToolMotion motion = solver.newMotion();
  private final SceneLegJudge judge = new SceneLegJudge(bodies, point, shapes);

  private static Body dot(String name, double x) {
    BitCube bits = new BitCube(3, 3, 3);
    bits.set(1, 1, 1);
    Body body = new Body(name, bits, VoxelGrid.ofUnitVoxels(3, 3, 3), Mobility.MOVABLE);
    body.setPose(Pose.at(x, 0, 0));
    return body;
  }

  /** Moves the second dot across the first or the tool, of which the solver knows nothing. */
  private static SceneLegJudge judged(double toolX, double first) {
    RigidTool point = ToolSampler.point();
    Body mover = dot("mover", 10);
    Body unknown = dot("unknown", first);
    BodyScene known = new BodyScene(List.of(dot("far", -500), mover));
    BodyScene seen = new BodyScene(List.of(unknown, mover));
    MovableShapes shapes = MovableShapes.ofPoints(known);
    RigidSolver solver = new RigidSolver(new RigidScene(known, point, shapes, SETTINGS));
    ToolMotion motion = solver.newMotion();
    solver.place(Pose.at(0, 90, 0), motion);
    SceneLegJudge judge = new SceneLegJudge(seen, point, shapes);
    judge.begin(motion);
    solver.bodies().setGoal(1, Pose.at(-10, 0, 0));
    solver.follow(Pose.at(toolX, 90, 0), motion);
    judge.judge(motion);
    return judge;
  }

  @Test
  void theLegJudgeFindsABodyThatMovesThroughAnother() {
    assertEquals(1, judged(0, 0).touching());
    assertEquals(0, judged(0, -100).touching());
    assertTrue(judged(0, -100).legs() > 0);
    assertEquals(0, judged(0, 0).broken());
  }

  private void begin() {
    solver.place(Pose.at(0, 90, 0), motion);
    judge.begin(motion);
  }

  @Test
  void theLegJudgeFindsAMotionThatNobodyReported() {
    begin();
    solver.follow(Pose.at(0, 91, 0), motion);
    judge.judge(motion);
    assertEquals(0, judge.broken());
    dot.setPose(Pose.at(11, 0, 0));
    judge.judge(motion);
    assertTrue(judge.broken() > 0);
  }

  @Test
  void aToolThatIsSetFreeInAnUnchangedSceneBreaksTheChain() {
    begin();
    solver.place(Pose.at(11.5, 1.5, 1.5), motion);
    assertTrue(motion.freed());
    judge.judge(motion);
    assertTrue(judge.broken() > 0);
  }

  @Test
  void theLegJudgeFindsABodyThatMovesOverTheTool() {
    solver.place(Pose.at(5, 90, 1.5), motion);
    solver.bodies().setGoal(0, Pose.at(-10, 0, 0));
    ToolMotion planted = new ToolMotion(1);
    Vec3 inTheWay = new Vec3(5, 1.5, 1.5);
    planted.pose().translation.set(inTheWay);
    judge.begin(planted);
    solver.follow(Pose.at(5, 90, 1.5), motion);
    motion.pathPose(0).translation.set(inTheWay);
    judge.judge(motion);
    assertEquals(1, judge.touching());
  }
}
