package org.palpate.host;

import java.util.Optional;
import java.util.OptionalDouble;
import org.palpate.force.FrictionForm;
import org.palpate.force.Material;

/**
 * Overrides parts of the general material for one segment. An empty value keeps the general one.
 *
 * @param stiffnessNewtonPerMm force per distance, N per mm of scan
 * @param friction static friction coefficient; also the kinetic one if that is not given
 * @param slidingFriction kinetic friction coefficient, at most the static one
 * @param dampingNewtonSecondPerMm force per speed, N s/mm
 */
public record MaterialOverride(
    OptionalDouble stiffnessNewtonPerMm,
    OptionalDouble friction,
    OptionalDouble slidingFriction,
    OptionalDouble dampingNewtonSecondPerMm) {
  /** The largest stiffness, N/mm. A force from a stiffer one may overflow. */
  private static final double MAX_STIFFNESS = 1e6;

  /** The least stiffness of a whole scene, N/mm. */
  private static final double MIN_STIFFNESS = 1e-6;

  /** Overrides nothing. */
  public static final MaterialOverride NONE =
      new MaterialOverride(
          OptionalDouble.empty(),
          OptionalDouble.empty(),
          OptionalDouble.empty(),
          OptionalDouble.empty());

  /**
   * Parses any of the four as in {@code stiffness:0.8,friction:0.3,sliding:0.2,damping:0.001}, each
   * at most once.
   *
   * <p>Returns empty if the text has another form, a number is negative or infinite, or sliding
   * exceeds friction.
   */
  public static Optional<MaterialOverride> parse(String text) {
    MaterialOverride override = NONE;
    for (String part : text.split(",", -1)) {
      int colon = part.indexOf(':');
      OptionalDouble value = number(part.substring(colon + 1));
      MaterialOverride next =
          colon < 0 || value.isEmpty() ? override : override.with(part.substring(0, colon), value);
      if (next.equals(override)) {
        return Optional.empty();
      }
      override = next;
    }
    double atRest = override.friction.orElse(Double.POSITIVE_INFINITY);
    return override.slidingFriction.orElse(0) > atRest ? Optional.empty() : Optional.of(override);
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

  /** Whether a stiffness, N/mm, can be felt at all and gives forces that are numbers. */
  public static boolean isFeasibleStiffness(double newtonPerMm) {
    return newtonPerMm >= MIN_STIFFNESS && newtonPerMm <= MAX_STIFFNESS;
  }

  /**
   * Returns a copy with one more value; this object if the name is unknown or already has a value.
   */
  private MaterialOverride with(String name, OptionalDouble value) {
    boolean isFeasible = value.orElse(0) <= MAX_STIFFNESS;
    if (name.equals("stiffness") && stiffnessNewtonPerMm.isEmpty() && isFeasible) {
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

  /** Returns the material of the segment over a general material. */
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
