package org.palpate.host;

import java.util.Optional;

/**
 * How collisions are found.
 *
 * @param method of the three
 * @param stepVoxels for {@link Method#SAMPLED} the distance of samples, grid coordinates; else 0
 */
public record CollisionChoice(Method method, double stepVoxels) {
  private static final String SAMPLED_PREFIX = "sampled:";

  /** The methods. */
  public enum Method {
    SAMPLED,
    GRIDPLANES,
    EXACT
  }

  public static final CollisionChoice EXACT = new CollisionChoice(Method.EXACT, 0);
  public static final CollisionChoice GRIDPLANES = new CollisionChoice(Method.GRIDPLANES, 0);

  public static CollisionChoice sampled(double stepVoxels) {
    return new CollisionChoice(Method.SAMPLED, stepVoxels);
  }

  /** Reads {@code sampled:STEP}, {@code gridplanes} or {@code exact}; empty where it is none. */
  public static Optional<CollisionChoice> parse(String text) {
    if (text.equals("exact")) {
      return Optional.of(EXACT);
    }
    if (text.equals("gridplanes")) {
      return Optional.of(GRIDPLANES);
    }
    return text.startsWith(SAMPLED_PREFIX)
        ? parseStep(text.substring(SAMPLED_PREFIX.length())).map(CollisionChoice::sampled)
        : Optional.empty();
  }

  private static Optional<Double> parseStep(String text) {
    try {
      double step = Double.parseDouble(text);
      return step > 0 && Double.isFinite(step) ? Optional.of(step) : Optional.empty();
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }

  /** As on the command line. */
  @Override
  public String toString() {
    return switch (method) {
      case SAMPLED -> SAMPLED_PREFIX + stepText();
      case GRIDPLANES -> "gridplanes";
      case EXACT -> "exact";
    };
  }

  private String stepText() {
    long whole = (long) stepVoxels;
    return whole == stepVoxels ? Long.toString(whole) : Double.toString(stepVoxels);
  }
}
