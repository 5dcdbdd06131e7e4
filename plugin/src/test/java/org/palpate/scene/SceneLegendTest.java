package org.palpate.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.SceneState.LegendEntry;

class SceneLegendTest {
  private final SceneModel model = new SceneModel(WorldAxes.LPS, Theme.DARK);

  @Test
  void aSceneWithoutALegendShowsNone() {
    add("bone");
    assertTrue(model.state().legend().isEmpty());
  }

  @Test
  void hidesTheSelectedSegmentAndShowsItAgain() {
    add("bone");
    add("skin");
    SceneLegend legend = new SceneLegend(model);
    legend.selectNext();
    legend.toggle();
    assertEquals(
        List.of(
            new LegendEntry("bone", 0x102030, true, false),
            new LegendEntry("skin", 0x102030, false, true)),
        model.state().legend());
    assertEquals(1, model.state().objects().size());
    legend.toggle();
    assertEquals(2, model.state().objects().size());
  }

  @Test
  void theSelectionBeginsAgainAfterTheLastSegment() {
    add("bone");
    add("skin");
    SceneLegend legend = new SceneLegend(model);
    legend.selectNext();
    legend.selectNext();
    assertTrue(model.state().legend().get(0).selected());
    legend.select(7);
    assertTrue(model.state().legend().get(0).selected(), "there is no segment 7");
  }

  @Test
  void coloursComeRoundToTheSegmentsOwn() {
    add("bone");
    SceneLegend legend = new SceneLegend(model);
    Set<Integer> seen = new HashSet<>();
    while (seen.add(model.state().objects().get(0).rgb())) {
      legend.nextColour();
    }
    assertEquals(0x102030, model.state().objects().get(0).rgb());
    assertTrue(seen.size() > 5);
  }

  @Test
  void anUpsideDownModelIsSeenWithTheFootAbove() {
    add("bone");
    model.setUpsideDown(true);
    model.look(StandardView.FRONT, 1);
    assertEquals(-1, model.state().camera().up().z);
    model.look(StandardView.LEFT, 1);
    assertEquals(-1, model.state().camera().up().z);
  }

  private void add(String name) {
    model.add(name, 0x102030, RigidTransform.identity(), new Vec3(), new Vec3(9, 9, 9));
  }
}
