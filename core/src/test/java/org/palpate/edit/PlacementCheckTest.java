package org.palpate.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.palpate.edit.ChangeLog.Answer;
import org.palpate.geometry.Pose;
import org.palpate.testing.Seeds;

/** Looks over several frames whether placed bodies may return, while others move. */
class PlacementCheckTest {
  /** The bodies lie on a line. Two are clear of each other if they are this far apart, mm. */
  private static final double CLEAR_MM = 1;

  /** Two may touch if they are nearer than this, mm. */
  private static final double NEAR_MM = 3;

  private static final int POINTS = 1300;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final Line line = new Line(4);
  private final PlacementLog log = new PlacementLog(line);
  private final UndoHistory history = new UndoHistory(List.of(log));

  /** Bodies on a line, each pair of which has 1,300 points to look at. */
  private static final class Line implements PlacementLog.Placer {
    private final List<Pose> poses = new ArrayList<>();
    private final long[] motions;
    private long edits;
    private long lookedAt;
    private double gapMm;
    private int left;

    Line(int count) {
      motions = new long[count];
      for (int n = 0; n < count; n++) {
        poses.add(Pose.at(10 * n, 0, 0));
      }
    }

    private double gap(Pose pose, int other) {
      return Math.abs(pose.translation.x - poses.get(other).translation.x);
    }

    @Override
    public int count() {
      return poses.size();
    }

    @Override
    public Pose pose(int body) {
      return poses.get(body);
    }

    @Override
    public long motions(int body) {
      return motions[body];
    }

    @Override
    public long edits() {
      return edits;
    }

    @Override
    public boolean isNear(int body, Pose pose, int other) {
      return gap(pose, other) < NEAR_MM;
    }

    @Override
    public void beginCheck(int body, Pose pose, int other) {
      gapMm = gap(pose, other);
      left = POINTS;
    }

    @Override
    public int continueCheck(int most) {
      int looked = Math.min(most, left);
      left -= looked;
      lookedAt += looked;
      return looked;
    }

    @Override
    public Answer checked() {
      return left > 0 ? Answer.LATER : gapMm >= CLEAR_MM ? Answer.YES : Answer.NO;
    }

    @Override
    public void place(int body, Pose pose) {
      poses.get(body).set(pose);
      motions[body]++;
    }

    void moveTo(int body, double x) {
      place(body, Pose.at(x, 0, 0));
    }
  }

  @BeforeEach
  void placeTheFirstBodyFarAway() {
    log.keepIn(history);
    place(0, 100);
  }

  private void place(int body, double x) {
    List<Pose> before = new ArrayList<>();
    line.poses.forEach(pose -> before.add(new Pose().set(pose)));
    line.moveTo(body, x);
    log.note(body, before);
    log.separate();
  }

  @Test
  void bodiesThatStandWhereTheyStoodNeedNoLook() {
    assertUndoneWithoutALook();
  }

  @Test
  void aBodyThatWentAndCameBackToTheBitNeedsNoLook() {
    line.moveTo(1, 0.5);
    line.moveTo(1, 10);
    assertUndoneWithoutALook();
  }

  private void assertUndoneWithoutALook() {
    assertTrue(history.undo(1));
    assertEquals(0, line.pose(0).translation.x);
    assertEquals(0, line.lookedAt);
  }

  @Test
  void aFrameLooksAtABoundedNumberOfPoints() {
    line.moveTo(1, 2);
    line.moveTo(2, 2.5);
    int frames = 0;
    boolean done;
    do {
      long before = line.lookedAt;
      done = history.undo(1);
      assertTrue(line.lookedAt - before <= PlacementCheck.POINTS_A_FRAME);
      frames++;
    } while (!done);
    assertEquals(0, line.pose(0).translation.x);
    assertEquals(2 * POINTS, line.lookedAt);
    assertTrue(frames > 2 * POINTS / PlacementCheck.POINTS_A_FRAME, "frames " + frames);
  }

  @Test
  void nothingMovesBeforeTheLookEnds() {
    line.moveTo(1, 2);
    history.undo(1);
    assertEquals(100, line.pose(0).translation.x);
    assertEquals(1, history.undoable());
    assertEquals(0, history.refused());
  }

  @Test
  void aBodyThatComesBehindTheLookIsSeen() {
    line.moveTo(1, 2);
    line.moveTo(2, 2.5);
    for (int frame = 0; frame < 4; frame++) {
      assertFalse(history.undo(1)); // body 1 is clear; now it looks at body 2
    }
    line.moveTo(1, 0.5);
    undoToTheEnd();
    assertEquals(100, line.pose(0).translation.x);
    assertEquals(1, history.refused());
  }

  @Test
  void aBodyThatMovesFarAwayDelaysNothing() {
    line.moveTo(1, 2);
    int frames = 1;
    for (; !history.undo(1); frames++) {
      line.moveTo(3, 30 + frames);
    }
    assertEquals(POINTS, line.lookedAt);
    assertTrue(frames <= 4, "frames " + frames);
  }

  @Test
  void anEditMakesTheLookBeginAnew() {
    line.moveTo(1, 2);
    history.undo(1);
    long before = line.lookedAt;
    line.edits++;
    undoToTheEnd();
    assertEquals(before + POINTS, line.lookedAt);
  }

  @Test
  void undoIsRefusedIfABodyGoesOnMovingNearby() {
    line.moveTo(1, 2);
    int frames = 1;
    for (; !history.undo(1); frames++) {
      line.moveTo(1, 2 + frames % 2 / 2.0);
    }
    assertEquals(100, line.pose(0).translation.x);
    assertEquals(1, history.refused());
    assertEquals(PlacementCheck.MOST_BEGINNINGS + 1, frames);
  }

  @Test
  void undoIsRefusedIfABodyStopsTheLookAgainAndAgainForTenSeconds() {
    line.moveTo(1, 2);
    line.moveTo(2, 2.5);
    line.moveTo(3, 2.5); // a look at all takes 8 frames
    int frames = 1;
    for (; !history.undo(1); frames++) {
      if (frames % 7 == 0) {
        line.moveTo(3, 2 + frames % 2 / 2.0);
      }
    }
    assertEquals(100, line.pose(0).translation.x);
    assertEquals(1, history.refused());
    assertEquals(PlacementCheck.MOST_FRAMES + 1, frames);
    assertTrue(frames / 7 < PlacementCheck.MOST_BEGINNINGS);
    line.moveTo(3, 30);
    undoToTheEnd();
    assertEquals(0, line.pose(0).translation.x);
  }

  @Test
  void whatIsUndoneIsAlwaysClearOfAllThatHasMoved() {
    int[] seen = new int[2];
    for (int n = 0; n < 2000; n++) {
      line.moveTo(1, random.nextDouble(4));
      line.moveTo(2, random.nextDouble(4));
      long refused = history.refused();
      while (!history.undo(1)) {
        if (random.nextInt(4) == 0) {
          line.moveTo(1 + random.nextInt(3), random.nextDouble(4));
        }
      }
      boolean clear = isClear(1) && isClear(2) && isClear(3);
      boolean isUndone = history.refused() == refused;
      assertEquals(clear, isUndone, "seed " + Seeds.seed() + " case " + n);
      seen[isUndone ? 1 : 0]++;
      if (isUndone) {
        history.redo(1);
        assertEquals(100, line.pose(0).translation.x);
      }
      line.moveTo(3, 30);
    }
    assertTrue(seen[0] > 100 && seen[1] > 100, "undone " + seen[1] + ", refused " + seen[0]);
  }

  /** Whether a body would be clear of the first one at its old place. */
  private boolean isClear(int other) {
    return line.gap(new Pose(), other) >= CLEAR_MM;
  }

  private void undoToTheEnd() {
    boolean done;
    do {
      done = history.undo(1);
    } while (!done);
  }
}
