package org.palpate.force;

import java.util.List;
import java.util.Optional;

/**
 * Settings of what the hand feels beside plain contact. Immutable.
 *
 * @param effects guides and effects, in the order in which their forces add up
 * @param mass the mass of the interaction point or tool, with gravity along the world's axes
 * @param materials materials that follow from grey values
 */
public record FeelSettings(
    List<EffectPlan> effects, Optional<MassSettings> mass, Optional<GreyMaterials> materials) {
  /** Plain contact. */
  public static final FeelSettings NONE =
      new FeelSettings(List.of(), Optional.empty(), Optional.empty());

  /** Copies the list. */
  public FeelSettings {
    effects = List.copyOf(effects);
  }
}
