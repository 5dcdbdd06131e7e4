package org.palpate.benchmarks.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.LegPath;
import org.palpate.volume.BitCube;

class ElasticLegJudgeTest {
  private final ElasticLegJudge judge = new ElasticLegJudge();
  private final BitCube bits = new BitCube(8, 8, 8);
  private final LegPath path = new LegPath();

  ElasticLegJudgeTest() {
    bits.set(4, 4, 4);
    judge.begin(new Vec3(0.5, 4.5, 4.5));
  }

  private void judge(double toX) {
    path.clear();
    path.add(0.5, 4.5, 4.5, toX, 4.5, 4.5, 1, false);
    judge.judge(path, new Vec3(toX, 4.5, 4.5), List.of(bits));
  }

  @Test
  void aLegThatEndsOnAFaceTouchesAndOneAnUlpBeforeItDoesNot() {
    judge(Math.nextDown(4.0));
    assertEquals(0, judge.touching());
    judge.begin(new Vec3(0.5, 4.5, 4.5));
    judge(4);
    assertEquals(1, judge.touching());
    assertEquals(2, judge.legs());
    assertEquals(0, judge.broken());
  }

  @Test
  void aLegThatBeginsElsewhereAndAPointThatStandsElsewhereBreakTheChain() {
    judge.begin(new Vec3(Math.nextUp(0.5), 4.5, 4.5));
    judge(2);
    assertEquals(1, judge.broken());
    judge.judge(new LegPath(), new Vec3(2, Math.nextUp(4.5), 4.5), List.of(bits));
    assertEquals(2, judge.broken());
  }

  @Test
  void oneLegInAHundredIsDecidedInFractionsTooAndAPlantedOneIsFound() {
    for (int leg = 0; leg < 2 * ElasticLegJudge.LEGS_PER_CHECK; leg++) {
      judge.begin(new Vec3(0.5, 4.5, 4.5));
      judge(3);
    }
    assertEquals(2, judge.compared());
    assertEquals(0, judge.differing());
    assertEquals(2, judge.plantedLegs());
    assertEquals(0, judge.plantedUnfound());
  }

  @Test
  void noLegIsPlantedFarFromSolids() {
    judge.begin(new Vec3(0.5, 4.5, 4.5));
    judge(0.5);
    assertEquals(1, judge.compared());
    assertEquals(0, judge.plantedLegs());
  }
}
