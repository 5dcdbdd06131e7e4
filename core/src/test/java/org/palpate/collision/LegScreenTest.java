package org.palpate.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.geometry.AffineMap;

/** Tests when motions are judged in a batch, and which share one. */
class LegScreenTest {
  private final Batch batch = new Batch();
  private final LegScreen screen = new LegScreen(batch);
  private final AffineMap from = new AffineMap();

  /** Calls legs free whose motion leads along x by less than 1. */
  private static final class Batch implements LegBatch {
    final MotionGroup judged = new MotionGroup();
    int launches;
    int motions;
    int atOnce = MotionGroup.CAPACITY;
    boolean fails;

    @Override
    public long crossover() {
      return 100;
    }

    @Override
    public int motionsAtOnce() {
      return atOnce;
    }

    @Override
    public boolean judge(MotionGroup group) {
      launches++;
      motions += group.count();
      judged.set(group);
      return !fails;
    }

    @Override
    public LegVerdict verdict(int motion, int point) {
      return judged.to(motion).offsetX < 1 ? LegVerdict.FREE : LegVerdict.HIT;
    }

    @Override
    public double emptyAround(int point) {
      return 0.25 * point;
    }
  }

  private static AffineMap by(double x) {
    AffineMap map = new AffineMap();
    map.offsetX = x;
    return map;
  }

  private boolean isFree(double x, long version, long legs) {
    screen.begin(from, by(x), version);
    boolean free = screen.isFree(0);
    screen.end(legs, true);
    assertFalse(screen.isFree(0), "a verdict outlives its motion");
    return free;
  }

  private void announce(double... ends) {
    for (int n = 0; n < ends.length; n++) {
      screen.announce(from, by(ends[n]), n == 0);
    }
  }

  @Test
  void fewLegsAreNotJudgedInABatch() {
    assertFalse(isFree(0.5, 0, 99));
    assertFalse(isFree(0.5, 0, 100));
    assertEquals(0, batch.launches);
    assertTrue(isFree(0.5, 0, 0));
    assertEquals(1, batch.launches);
  }

  @Test
  void anEarlyHitCountsFewerLegsThanTheLastMotionHad() {
    isFree(0, 0, 1_000);
    screen.begin(from, by(4), 0);
    screen.end(3, false);
    assertTrue(isFree(0.5, 0, 0), "the motion before had many legs");
    assertEquals(2, batch.launches);
    assertFalse(isFree(0.5, 1, 0), "all legs were counted, and there were none");
    screen.begin(from, by(4), 1);
    screen.end(200, false);
    assertTrue(isFree(0.25, 1, 0), "an early hit after many legs");
    assertEquals(3, batch.launches);
  }

  @Test
  void onlyADeviceThatTakesSeveralMotionsIsToldThem() {
    assertTrue(screen.takesAnnouncements());
    batch.atOnce = 2;
    assertTrue(screen.takesAnnouncements());
    batch.atOnce = 1;
    assertFalse(screen.takesAnnouncements());
  }

  @Test
  void aFirstAnnouncementForgetsTheOthers() {
    isFree(0, 0, 1_000);
    announce(4, 2);
    announce(0.5);
    assertTrue(isFree(0.5, 0, 1_000));
    assertEquals(1, batch.motions);
  }

  @Test
  void theEmptyCubesAreThoseOfTheBatch() {
    assertEquals(0.75, screen.emptyAround(3));
  }

  @Test
  void announcedMotionsShareOneLaunch() {
    isFree(0, 0, 1_000);
    announce(4, 2, 1, 0.5);
    assertFalse(isFree(4, 0, 1_000));
    assertFalse(isFree(1, 0, 1_000));
    assertTrue(isFree(0.5, 0, 1_000));
    assertEquals(1, batch.launches);
    assertEquals(4, batch.motions);
  }

  @Test
  void aMotionThatWasNotAnnouncedIsJudgedAlone() {
    isFree(0, 0, 1_000);
    announce(4, 2);
    assertTrue(isFree(0.25, 0, 1_000));
    assertEquals(1, batch.motions);
    assertFalse(isFree(4, 0, 1_000));
    assertEquals(3, batch.motions);
  }

  @Test
  void verdictsEndWithTheStartAndWithTheVoxels() {
    isFree(0, 0, 1_000);
    announce(4, 0.5);
    assertFalse(isFree(4, 0, 1_000));
    assertTrue(isFree(0.5, 1, 1_000));
    assertEquals(2, batch.launches);
    from.offsetY = 1;
    assertTrue(isFree(0.5, 1, 1_000));
    assertEquals(3, batch.launches);
  }

  @Test
  void moreMotionsThanADeviceTakesAreLeftOut() {
    batch.atOnce = 2;
    isFree(0, 0, 1_000);
    announce(4, 2, 0.5);
    isFree(4, 0, 1_000);
    assertEquals(2, batch.motions);
    assertTrue(isFree(0.5, 0, 1_000));
    assertEquals(2, batch.launches);
  }

  @Test
  void aFailedBatchGivesNoVerdict() {
    isFree(0, 0, 1_000);
    batch.fails = true;
    announce(0.5, 0.25);
    assertFalse(isFree(0.5, 0, 1_000));
    assertFalse(isFree(0.25, 0, 1_000));
    assertEquals(2, batch.launches);
  }
}
