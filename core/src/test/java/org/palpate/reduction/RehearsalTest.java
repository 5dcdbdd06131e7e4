package org.palpate.reduction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;
import org.palpate.rigid.MovableShapes;

class RehearsalTest {
  private static final long FRAMES = 100_000;
  private static final List<Pose> FROM_ABOVE = List.of(new Pose(), Pose.at(0, 0, 30));
  private static final List<Pose> FROM_THE_SIDE = List.of(new Pose(), Pose.at(30, 0, 0));

  /** A peg in a hole that is half a voxel wider on each side for its sample points. */
  private final BodyScene scene =
      new BodyScene(List.of(BlockWithHole.block(), BlockWithHole.peg()));

  @Test
  void aTremblingHandBringsAPegHomeFromAbove() {
    assertEquals(1, rehearsal(FRAMES).arrivals(1, FROM_ABOVE));
    assertTrue(scene.body(1).pose().sameBits(new Pose()), "is back in its place");
  }

  @Test
  void noHandBringsItHomeThroughTheWall() {
    assertEquals(0, rehearsal(FRAMES).arrivals(1, FROM_THE_SIDE));
    assertTrue(scene.body(1).pose().sameBits(new Pose()), "is back in its place");
  }

  @Test
  void everyWayCountsOnceTheFramesAreSpent() {
    Rehearsal rehearsal = rehearsal(1);
    assertEquals(0, rehearsal.arrivals(1, FROM_THE_SIDE), "takes them all");
    assertEquals(1, rehearsal.arrivals(1, FROM_THE_SIDE));
  }

  private Rehearsal rehearsal(long mostFrames) {
    return new Rehearsal(scene, MovableShapes.ofPoints(scene), mostFrames);
  }
}
