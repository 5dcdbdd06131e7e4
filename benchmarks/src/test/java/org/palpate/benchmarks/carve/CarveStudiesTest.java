package org.palpate.benchmarks.carve;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.benchmarks.rigid.RigidFigure;

class CarveStudiesTest {
  private static final long SEED = 3;

  @Test
  void theAttackOnToolsThatCutFindsNothing() {
    List<RigidFigure> figures =
        new CarveStudy(CarveStudy.Tools.FEW_POINTS, SEED, line -> {}).figures(14_000);
    assertNothingMissed(figures);
    assertTrue(value(figures, "voxels removed or filled") > 1_000);
    assertTrue(value(figures, "strokes undone and redone") > 50);
    assertTrue(value(figures, "frames judged for the margin") > 2_000);
  }

  @Test
  void theAttackOnToolsOfManyPointsFindsNothing() {
    List<RigidFigure> figures =
        new CarveStudy(CarveStudy.Tools.MANY_POINTS, SEED, line -> {}).figures(2_000);
    assertNothingMissed(figures);
    double points = value(figures, "points of a tool, mean");
    assertTrue(points > 800 && points < 1_300, "points " + points);
  }

  @Test
  void theAttackOnPointsThatCutFindsNothing() {
    List<RigidFigure> figures = new PointCarveStudy(SEED, line -> {}).figures(50_000);
    assertNothingMissed(figures);
    assertTrue(value(figures, "voxels removed or filled") > 1_000);
    assertTrue(value(figures, "points set free") > 5);
  }

  private static void assertNothingMissed(List<RigidFigure> figures) {
    figures.forEach(figure -> assertTrue(!figure.verdict().equals("missed"), figure.toString()));
  }

  @Test
  void theTimedBurrCuts() {
    assertTrue(value(new CarveTimes(300).figures(), "voxels removed") > 100);
  }

  @Test
  void everyCutReachesTheScene() {
    List<RigidFigure> figures = RemeshTimes.figures(300);
    assertTrue(value(figures, "voxels removed") > 100);
    assertTrue(value(figures, "cut to surface p50") > 0);
  }

  private static double value(List<RigidFigure> figures, String name) {
    return figures.stream().filter(f -> f.name().equals(name)).findFirst().orElseThrow().value();
  }
}
