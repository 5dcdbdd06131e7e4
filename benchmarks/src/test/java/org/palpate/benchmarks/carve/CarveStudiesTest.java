package org.palpate.benchmarks.carve;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.benchmarks.rigid.RigidFigure;

class CarveStudiesTest {
  private static final long SEED = 3;

  @Test
  void theAttackOnToolsThatCutFindsNothing() {
    List<RigidFigure> figures = new CarveStudy(SEED).figures(10_000);
    figures.forEach(figure -> assertTrue(!figure.verdict().equals("missed"), figure.toString()));
    assertTrue(value(figures, "voxels removed or filled") > 1_000);
    assertTrue(value(figures, "strokes undone and done again") > 50);
  }

  @Test
  void theTimedBurrCuts() {
    assertTrue(value(new CarveTimes(300).figures(), "voxels removed") > 100);
  }

  @Test
  void everyCutReachesTheScene() {
    List<RigidFigure> figures = new RemeshTimes(300).figures();
    assertTrue(value(figures, "voxels removed") > 100);
    assertTrue(value(figures, "cut to surface p50") > 0);
  }

  private static double value(List<RigidFigure> figures, String name) {
    return figures.stream().filter(f -> f.name().equals(name)).findFirst().orElseThrow().value();
  }
}
