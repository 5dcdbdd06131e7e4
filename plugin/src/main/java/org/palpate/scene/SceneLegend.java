package org.palpate.scene;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The legend of a scene: shows the segments with their colours, hides them, and changes colours.
 * Any thread.
 */
public final class SceneLegend {
  private static final List<Integer> COLOURS =
      List.of(
          Palette.SKY_BLUE,
          Palette.BLUISH_GREEN,
          Palette.REDDISH_PURPLE,
          Palette.YELLOW,
          Palette.BLUE,
          Palette.ORANGE);

  private final SceneModel model;

  /** The colours that segments had at first. */
  private final Map<SceneObject, Integer> original = new HashMap<>();

  private int selected;

  /** Creates a legend and shows it; segments may be added later. */
  public SceneLegend(SceneModel model) {
    this.model = model;
    model.setLegend(selected);
  }

  /** Selects the next segment. */
  public synchronized void selectNext() {
    int count = model.objects().size();
    selected = count == 0 ? 0 : (selected + 1) % count;
    model.setLegend(selected);
  }

  /** Selects a segment by its number, if there is one. */
  public synchronized void select(int number) {
    if (number >= 0 && number < model.objects().size()) {
      selected = number;
      model.setLegend(selected);
    }
  }

  /** Hides the selected segment, or shows it again. It can be touched all the same. */
  public synchronized void toggle() {
    List<SceneObject> objects = model.objects();
    if (selected < objects.size()) {
      SceneObject object = objects.get(selected);
      model.setVisible(object, !model.isVisible(object));
    }
  }

  /** Gives the selected segment the next colour; after the last one it has its own again. */
  public synchronized void nextColour() {
    List<SceneObject> objects = model.objects();
    if (selected < objects.size()) {
      SceneObject object = objects.get(selected);
      int own = original.computeIfAbsent(object, model::colour);
      int next = COLOURS.indexOf(model.colour(object)) + 1;
      boolean atOwn = model.colour(object) == own;
      int index = atOwn ? 0 : next;
      model.setColour(object, index < COLOURS.size() ? COLOURS.get(index) : own);
    }
  }
}
