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
 * @param cutNewton the force below which a cutting tool meets a hard wall, N
 */
public record MaterialOverride(
    OptionalDouble stiffnessNewtonPerMm,
    OptionalDouble friction,
    OptionalDouble slidingFriction,
    OptionalDouble dampingNewtonSecondPerMm,
    OptionalDouble cutNewton) {
  /** The smallest stiffness other than 0, N/mm. */
  public static final double LEAST_STIFFNESS = 1e-6;

  /** The largest stiffness, N/mm. A larger one gives forces that no device can represent. */
  public static final double MOST_STIFFNESS = 1e6;

  /** The largest friction coefficient. */
  public static final double MOST_FRICTION = 100;

  private static final double MOST_DAMPING = 1e6;

  /** Overrides nothing. */
  public static final MaterialOverride NONE =
      new MaterialOverride(
          OptionalDouble.empty(),
          OptionalDouble.empty(),
          OptionalDouble.empty(),
          OptionalDouble.empty(),
          OptionalDouble.empty());

  /**
   * Parses any of the five as in {@code
   * stiffness:0.8,friction:0.3,sliding:0.2,damping:0.001,cut:0.5}, each at most once.
   *
   * <p>Returns empty if the text has another form, a number is out of its range, or sliding exceeds
   * friction. A stiffness of 0 is allowed: the user does not feel such a segment.
   */
  public static Optional<MaterialOverride> parse(String text) {
    MaterialOverride override = NONE;
    for (String part : text.split(",", -1)) {
      int colon = part.indexOf(':');
      String name = colon < 0 ? "" : part.substring(0, colon);
      OptionalDouble value = number(part.substring(colon + 1), name);
      MaterialOverride next = value.isEmpty() ? override : override.with(name, value);
      if (next.equals(override)) {
        return Optional.empty();
      }
      override = next;
    }
    double atRest = override.friction.orElse(Double.POSITIVE_INFINITY);
    return override.slidingFriction.orElse(0) > atRest ? Optional.empty() : Optional.of(override);
  }

  private static OptionalDouble number(String text, String name) {
    try {
      double value = Double.parseDouble(text);
      return value == 0 || isInRange(value, name)
          ? OptionalDouble.of(value)
          : OptionalDouble.empty();
    } catch (NumberFormatException e) {
      return OptionalDouble.empty();
    }
  }

  /**
   * Whether a stiffness, N/mm, lies between {@link #LEAST_STIFFNESS} and {@link #MOST_STIFFNESS}.
   */
  public static boolean isFeasibleStiffness(double newtonPerMm) {
    return newtonPerMm >= LEAST_STIFFNESS && newtonPerMm <= MOST_STIFFNESS;
  }

  private static boolean isInRange(double value, String name) {
    return switch (name) {
      case "stiffness" -> isFeasibleStiffness(value);
      case "friction", "sliding" -> value > 0 && value <= MOST_FRICTION;
      default -> value > 0 && value <= MOST_DAMPING;
    };
  }

  /**
   * Returns a copy with one more value; this object if the name is unknown or already has a value.
   */
  private MaterialOverride with(String name, OptionalDouble value) {
    if (name.equals("stiffness") && stiffnessNewtonPerMm.isEmpty()) {
      return new MaterialOverride(
          value, friction, slidingFriction, dampingNewtonSecondPerMm, cutNewton);
    }
    if (name.equals("friction") && friction.isEmpty()) {
      return new MaterialOverride(
          stiffnessNewtonPerMm, value, slidingFriction, dampingNewtonSecondPerMm, cutNewton);
    }
    if (name.equals("sliding") && slidingFriction.isEmpty()) {
      return new MaterialOverride(
          stiffnessNewtonPerMm, friction, value, dampingNewtonSecondPerMm, cutNewton);
    }
    if (name.equals("damping") && dampingNewtonSecondPerMm.isEmpty()) {
      return new MaterialOverride(
          stiffnessNewtonPerMm, friction, slidingFriction, value, cutNewton);
    }
    if (name.equals("cut") && cutNewton.isEmpty()) {
      return new MaterialOverride(
          stiffnessNewtonPerMm, friction, slidingFriction, dampingNewtonSecondPerMm, value);
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
