package org.palpate.host;

import java.util.List;
import java.util.Optional;
import org.palpate.scene.MovableSlices;
import org.palpate.scene.surface.GreyRange;
import org.palpate.scene.window.ScenePanel;

/**
 * What a view shows beside surfaces of bits.
 *
 * @param greys what each segment was made of, where its surface is to go by grey values, in the
 *     order of the segments; those that are missing at the end go by their bits
 * @param slices planes of grey values, with keys that switch and move them
 * @param panel the place in another program's window where it is shown; a window of its own where
 *     empty
 */
public record ViewOptions(
    List<Optional<GreyRange>> greys,
    Optional<MovableSlices.Start> slices,
    Optional<ScenePanel> panel) {
  /** Surfaces of bits in a window of its own. */
  public static final ViewOptions PLAIN =
      new ViewOptions(List.of(), Optional.empty(), Optional.empty());

  /** Copies the list. */
  public ViewOptions {
    greys = List.copyOf(greys);
  }

  /** The same inside another program's window. */
  public ViewOptions in(ScenePanel place) {
    return new ViewOptions(greys, slices, Optional.of(place));
  }
}
