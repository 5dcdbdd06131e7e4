package org.palpate.reduction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.reduction.TouchSearch.Touch;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;

/** A peg lies beside a block. It is 8 mm long, and its ends are 4 by 4 mm. */
class TouchSearchTest {
  private static final int PEG = 1;
  private static final Pose BESIDE = Pose.at(0, 40, 0);
  private static final Vec3 UP = new Vec3(0, 0, 1);

  private final BodyScene scene =
      new BodyScene(List.of(BlockWithHole.block(), BlockWithHole.peg()));

  private final FreeLines lines = new FreeLines(scene);

  @Test
  void aPegThatStaysOutsideIsTouchedNearItsMiddle() {
    Touch touch = touch(Pose.at(40, 0, 0));
    Vec3 at = BESIDE.inverseTransform(touch.at(), new Vec3());
    assertEquals(8, at.z, 2, "beside its middle: " + at);
  }

  @Test
  void aPegThatGoesIntoTheHoleIsTouchedAtItsFreeEnd() {
    Touch touch = touch(new Pose());
    Vec3 at = BESIDE.inverseTransform(touch.at(), new Vec3());
    assertEquals(12, at.z, 0.5, "at its upper end: " + at);
    assertTrue(isFree(touch.at(), touch.outward()), "the hand comes along a free line");
    scene.body(PEG).setPose(new Pose());
    assertTrue(isFree(at, touch.off()), "the hand leaves along a free line: " + touch.off());
  }

  @Test
  void theSearchMovesNoBody() {
    touch(new Pose());
    assertTrue(scene.body(PEG).pose().sameBits(BESIDE));
  }

  @Test
  void oneBodyCanBeLeftOut() {
    scene.body(PEG).setPose(BESIDE);
    Vec3 inHole = new Vec3(8, 8, 6);
    Vec3 inBlock = new Vec3(8, 8, 2);
    assertFalse(lines.isFree(inHole, inBlock));
    assertTrue(lines.isFreeBut(0, inHole, inBlock), "but for the block");
    assertFalse(lines.isFreeBut(PEG, inHole, inBlock), "the block is in the way");
  }

  /** Whether a line is free that begins outside of the fragment itself. */
  private boolean isFree(Vec3 at, Vec3 direction) {
    Vec3 begin = direction.mul(2, new Vec3()).add(at, new Vec3());
    return lines.isFree(begin, direction.mul(60, new Vec3()).add(at, new Vec3()));
  }

  private Touch touch(Pose end) {
    scene.body(PEG).setPose(BESIDE);
    List<RigidTool> shapes = List.of(shape(scene.body(0)), shape(scene.body(PEG)));
    BallAround ball = new BallAround(List.of(new Vec3(8, 8, 8)));
    ball.reachTo(60);
    return new TouchSearch(scene, shapes, ball).find(PEG, end, UP);
  }

  private static RigidTool shape(Body body) {
    return ToolSampler.ofSegment(body.bits(), body.grid());
  }
}
