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

/**
 * The hand holds one body, and another moves along with it. The solver knows the third body far
 * away; the judge sees it where the test puts it.
 */
class SceneGroupJudgeTest {
  private static final RigidSettings SETTINGS = RigidSettings.of(100, Clearance.POINTS);
  private static final int HELD = 0;
  private static final int CARRIED = 1;
  private static final double FAR = -700;

  private final RigidTool point = ToolSampler.point();
  private BodyScene known;
  private BodyScene seen;
  private RigidSolver tool;
  private RigidSolver holding;
  private ToolMotion motion;
  private SceneLegJudge judge;

  private static Body dot(String name, Vec3 at) {
    BitCube bits = new BitCube(3, 3, 3);
    bits.set(1, 1, 1);
    Body body = new Body(name, bits, VoxelGrid.ofUnitVoxels(3, 3, 3), Mobility.MOVABLE);
    body.setPose(Pose.at(at.x, at.y, at.z));
    return body;
  }

  /** Begins with a held dot at 0, a carried one at y = 10, and a third one where the judge sees. */
  private void begin(Vec3 third) {
    Body held = dot("held", new Vec3());
    Body carried = dot("carried", new Vec3(0, 10, 0));
    known = new BodyScene(List.of(held, carried, dot("third", new Vec3(FAR, 0, 0))));
    seen = new BodyScene(List.of(held, carried, dot("third", third)));
    MovableShapes shapes = MovableShapes.ofPoints(known);
    tool = new RigidSolver(new RigidScene(known, point, shapes, SETTINGS));
    motion = tool.newMotion();
    tool.place(Pose.at(0, 90, 0), motion);
    judge = new SceneLegJudge(seen, point, shapes);
    judge.begin(motion);
    take(true);
  }

  private void take(boolean together) {
    holding = tool.ofBody(HELD);
    holding.takeOver(motion);
    judge.take(HELD, motion);
    if (together) {
      holding.carry(CARRIED);
      judge.join(CARRIED);
    }
  }

  private void pull(double x, double y, double z) {
    Pose device = new Pose().set(motion.pose());
    Vec3 at = device.translation;
    at.set(at.x + x, at.y + y, at.z + z);
    holding.follow(device, motion);
    judge.judge(motion);
  }

  @Test
  void aBodyThatMovesAlongIsFoundWhereItIs() {
    begin(new Vec3(0, 0, 50));
    pull(5, 0, 2);
    assertTrue(motion.steps() > 0);
    assertEquals(0, judge.broken());
    assertEquals(0, judge.touching());
    assertEquals(5, known.body(CARRIED).pose().translation.x, 1e-6, "it moved along");
    pull(-5, 0, -2);
    assertEquals(0, judge.broken(), "and back");
  }

  @Test
  void aBodyThatWasNotReportedToMoveAlongBreaksTheChain() {
    begin(new Vec3(0, 0, 50));
    holding.carryNone();
    pull(5, 0, 0);
    assertEquals(1, judge.broken(), "the judge expects the carried body 5 mm away");
  }

  @Test
  void aBodyThatMovesAlongUnreportedBreaksTheChain() {
    begin(new Vec3(0, 0, 50));
    holding.carryNone();
    judge.letGo(motion);
    take(false);
    holding.carry(CARRIED);
    pull(5, 0, 0);
    assertEquals(1, judge.broken());
  }

  @Test
  void aHeldBodyThatPassesThroughAnotherIsFound() {
    begin(new Vec3(4, 0, 0));
    pull(8, 0, 0);
    assertEquals(1, judge.touching(), "the held dot passes the third");
    assertEquals(0, judge.broken());
  }

  @Test
  void aCarriedBodyThatPassesThroughAnotherIsFound() {
    begin(new Vec3(4, 10, 0));
    pull(8, 0, 0);
    assertEquals(1, judge.touching(), "the carried dot passes the third");
    assertEquals(0, judge.broken());
    pull(-4, 0, 0);
    assertEquals(2, judge.touching(), "and lies in it at the end of the way back");
  }

  @Test
  void aCarriedBodyThatPassesBesideAnotherIsFree() {
    begin(new Vec3(4, 11.5, 0));
    pull(8, 0, 0);
    assertEquals(0, judge.touching());
  }

  @Test
  void aHeldBodyAndThoseBesideItAreJudgedAgainstEachOther() {
    begin(new Vec3(0, 0, 50));
    long before = judge.legs();
    pull(5, 0, 0);
    int steps = motion.steps();
    assertEquals(3L * steps, judge.legs() - before, "three pairs of bodies, and no tool");
  }

  @Test
  void whileTheHandHoldsABodyTheToolIsNoObstacle() {
    begin(new Vec3(0, 0, 50));
    pull(0, 100, 0);
    assertEquals(0, judge.touching(), "the held dot passed where the tool was");
  }

  @Test
  void afterTheHandLetGoTheToolIsInTheSceneAgain() {
    begin(new Vec3(0, 0, 50));
    pull(5, 0, 0);
    ToolMotion placed = new ToolMotion(3);
    placed.pose().translation.set(6.5, 1.5, 1.5);
    judge.letGo(placed);
    assertEquals(1, judge.touching(), "the tool was placed in the held dot, 5 mm on its way");
    placed.pose().translation.set(1.5, 1.5, 1.5);
    judge.letGo(placed);
    assertEquals(1, judge.touching(), "where the dot was before there is nothing");
  }

  @Test
  void afterTheHandLetGoNothingMovesAlong() {
    begin(new Vec3(0, 0, 50));
    pull(5, 0, 0);
    holding.carryNone();
    judge.letGo(motion);
    take(false);
    pull(5, 0, 0);
    assertEquals(0, judge.broken());
    assertEquals(5, known.body(CARRIED).pose().translation.x, 1e-6);
  }

  @Test
  void beginAgainTakesThePosesAsTheyAre() {
    begin(new Vec3(0, 0, 50));
    seen.body(2).setPose(Pose.at(3, 3, 3));
    pull(1, 0, 0);
    assertEquals(1, judge.broken());
    judge.letGo(motion);
    motion.rest();
    judge.begin(motion);
    judge.judge(motion);
    assertEquals(1, judge.broken(), "nothing new is broken");
  }

  @Test
  void aPathThatDoesNotStartWhereTheLastOneEndedIsBroken() {
    begin(new Vec3(0, 0, 50));
    pull(1, 0, 0);
    holding.rest(motion);
    judge.judge(motion);
    assertEquals(0, judge.broken());
    motion.pathPose(0).translation.z += 0x1p-20;
    judge.judge(motion);
    assertEquals(2, judge.broken(), "at the begin and at the end of the path");
  }
}
