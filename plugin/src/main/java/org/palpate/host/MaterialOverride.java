package org.palpate.host;

import java.util.Optional;
import java.util.OptionalDouble;
import org.palpate.force.FrictionForm;
import org.palpate.force.Material;

/**
 * What of a segment feels otherwise than the rest; what is empty is as with the others.
 *
 * @param stiffnessNewtonPerMm force over distance, of scan
 * @param friction at rest, and sliding where that has none of its own
 * @param slidingFriction of a slide, at most that at rest
 * @param dampingNewtonSecondPerMm force over speed
 */
public record MaterialOverride(
    OptionalDouble stiffnessNewtonPerMm,
    OptionalDouble friction,
    OptionalDouble slidingFriction,
    OptionalDouble dampingNewtonSecondPerMm) {

  /** Nothing differs. */
  public static final MaterialOverride NONE =
      new MaterialOverride(
          OptionalDouble.empty(),
          OptionalDouble.empty(),
          OptionalDouble.empty(),
          OptionalDouble.empty());

  /**
   * Reads {@code stiffness:0.8,friction:0.3,sliding:0.2,damping:0.001}, any of the four, each once;
   * empty where it is not that, a number is below 0 or infinite, or sliding is above friction.
   */
  public static Optional<MaterialOverride> parse(String text) {
    MaterialOverride choice = NONE;
    for (String part : text.split(",", -1)) {
      int colon = part.indexOf(':');
      OptionalDouble value = number(part.substring(colon + 1));
      MaterialOverride next =
          colon < 0 || value.isEmpty() ? choice : choice.with(part.substring(0, colon), value);
      if (next.equals(choice)) {
        return Optional.empty();
      }
      choice = next;
    }
    double atRest = choice.friction.orElse(Double.POSITIVE_INFINITY);
    return choice.slidingFriction.orElse(0) > atRest ? Optional.empty() : Optional.of(choice);
  }

  private static OptionalDouble number(String text) {
    try {
      double value = Double.parseDouble(text);
      return value >= 0 && value <= Double.MAX_VALUE
          ? OptionalDouble.of(value)
          : OptionalDouble.empty();
    } catch (NumberFormatException e) {
      return OptionalDouble.empty();
    }
  }

  /** The same with one more number; itself where there is no such name or it has been given. */
  private MaterialOverride with(String name, OptionalDouble value) {
    if (name.equals("stiffness") && stiffnessNewtonPerMm.isEmpty()) {
      return new MaterialOverride(value, friction, slidingFriction, dampingNewtonSecondPerMm);
    }
    if (name.equals("friction") && friction.isEmpty()) {
      return new MaterialOverride(
          stiffnessNewtonPerMm, value, slidingFriction, dampingNewtonSecondPerMm);
    }
    if (name.equals("sliding") && slidingFriction.isEmpty()) {
      return new MaterialOverride(stiffnessNewtonPerMm, friction, value, dampingNewtonSecondPerMm);
    }
    if (name.equals("damping") && dampingNewtonSecondPerMm.isEmpty()) {
      return new MaterialOverride(stiffnessNewtonPerMm, friction, slidingFriction, value);
    }
    return this;
  }

  /** The material of a segment among others of a general one. */
  Material over(Material general, FrictionForm form) {
    double atRest = friction.orElse(Math.max(general.staticFriction(), slidingFriction.orElse(0)));
    double sliding = slidingFriction.orElse(form.slidingFraction() * atRest);
    return new Material(
        stiffnessNewtonPerMm.orElse(general.stiffnessNewtonPerMm()),
        atRest,
        sliding,
        dampingNewtonSecondPerMm.orElse(general.dampingNewtonSecondPerMm()));
  }
}
