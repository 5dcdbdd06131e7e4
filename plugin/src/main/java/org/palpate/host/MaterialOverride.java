package org.palpate.host;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.palpate.force.FrictionForm;
import org.palpate.force.Material;
import org.palpate.force.needle.NeedleTissue;
import org.palpate.volume.BitCube;

/**
 * Overrides parts of the general material for one segment. What is missing keeps the general value.
 *
 * @param values the numbers by their keys, in the units of {@link #KEYS}
 */
public record MaterialOverride(Map<String, Double> values) {
  /** The keys: N/mm, two coefficients of friction, N s/mm, three forces in N, and N/mm. */
  private static final List<String> KEYS =
      List.of("stiffness", "friction", "sliding", "damping", "cut", "puncture", "cutting", "shaft");

  /** The smallest stiffness other than 0, N/mm. */
  public static final double LEAST_STIFFNESS = 1e-6;

  /** The largest stiffness, N/mm. A larger one gives forces that no device can represent. */
  public static final double MOST_STIFFNESS = 1e6;

  /** The largest friction coefficient. */
  public static final double MOST_FRICTION = 100;

  private static final double MOST_DAMPING = 1e6;

  /** Overrides nothing. */
  public static final MaterialOverride NONE = new MaterialOverride(Map.of());

  /** Copies the map. */
  public MaterialOverride {
    values = Map.copyOf(values);
  }

  /**
   * Parses any of the keys as in {@code stiffness:0.8,friction:0.3,sliding:0.2}, each at most once.
   * A stiffness of 0 is allowed: the user does not feel such a segment.
   *
   * @param text the text of a user
   * @return the override; empty if the text has another form, a number is out of its range, sliding
   *     exceeds friction, or a needle is to cut or rub without a puncture
   */
  public static Optional<MaterialOverride> parse(String text) {
    Map<String, Double> read = new HashMap<>();
    for (String part : text.split(",", -1)) {
      int colon = part.indexOf(':');
      String name = colon < 0 ? "" : part.substring(0, colon);
      OptionalDouble value = number(part.substring(colon + 1), name);
      boolean isNew = KEYS.contains(name) && value.isPresent() && !read.containsKey(name);
      if (!isNew) {
        return Optional.empty();
      }
      read.put(name, value.getAsDouble());
    }
    double atRest = read.getOrDefault("friction", Double.POSITIVE_INFINITY);
    boolean ofNeedle = read.containsKey("cutting") || read.containsKey("shaft");
    boolean isRefused =
        read.getOrDefault("sliding", 0.0) > atRest || (ofNeedle && !read.containsKey("puncture"));
    return isRefused ? Optional.empty() : Optional.of(new MaterialOverride(read));
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
   * {@return whether a stiffness lies between {@link #LEAST_STIFFNESS} and {@link #MOST_STIFFNESS}}
   *
   * @param newtonPerMm the stiffness, N/mm
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

  private OptionalDouble value(String key) {
    Double value = values.get(key);
    return value == null ? OptionalDouble.empty() : OptionalDouble.of(value);
  }

  /** {@return the force below which a cutting tool meets a hard wall, N} */
  public double cutNewton() {
    return values.getOrDefault("cut", 0.0);
  }

  /** Returns the segment as a tissue that a needle may enter; empty if it may not. */
  Optional<NeedleTissue> tissue(BitCube bits) {
    return isPenetrable()
        ? Optional.of(
            new NeedleTissue(
                bits,
                values.get("puncture"),
                values.getOrDefault("cutting", 0.0),
                values.getOrDefault("shaft", 0.0)))
        : Optional.empty();
  }

  /** {@return whether a needle may enter the segment} */
  public boolean isPenetrable() {
    return values.containsKey("puncture");
  }

  /** Returns the material of the segment over a general material. */
  Material over(Material general, FrictionForm form) {
    double atRest =
        value("friction").orElse(Math.max(general.staticFriction(), value("sliding").orElse(0)));
    double sliding = value("sliding").orElse(form.slidingFraction() * atRest);
    return new Material(
        value("stiffness").orElse(general.stiffnessNewtonPerMm()),
        atRest,
        sliding,
        value("damping").orElse(general.dampingNewtonSecondPerMm()));
  }
}
