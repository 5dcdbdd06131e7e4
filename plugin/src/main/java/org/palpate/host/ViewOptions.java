package org.palpate.host;

import java.util.List;
import java.util.Optional;
import org.palpate.scene.MovableSlices;
import org.palpate.scene.surface.GreyRange;

/**
 * What a view shows beside surfaces of bits.
 *
 * @param greys what each segment was made of, where its surface is to go by grey values, in the
 *     order of the segments; those that are missing at the end go by their bits
 * @param slices planes of grey values, with keys that switch and move them
 */
public record ViewOptions(List<Optional<GreyRange>> greys, Optional<MovableSlices.Start> slices) {
  /** Surfaces of bits and nothing else. */
  public static final ViewOptions PLAIN = new ViewOptions(List.of(), Optional.empty());

  /** Copies the list. */
  public ViewOptions {
    greys = List.copyOf(greys);
  }
}
