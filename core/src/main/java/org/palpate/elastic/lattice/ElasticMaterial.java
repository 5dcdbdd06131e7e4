package org.palpate.elastic.lattice;

import java.util.Optional;
import java.util.function.ToDoubleFunction;

/**
 * A linear elastic material.
 *
 * @param youngPascal Young's modulus, Pa
 * @param poisson Poisson's ratio
 */
public record ElasticMaterial(double youngPascal, double poisson) {
  /** The softest modulus, Pa. */
  public static final double LEAST_YOUNG_PASCAL = 10;

  /** The stiffest modulus, Pa. */
  public static final double MOST_YOUNG_PASCAL = 1e12;

  /** The largest ratio: closer to 0.5, elements with one point of rotation lock. */
  public static final double MOST_POISSON = 0.49;

  /** The ratio of soft tissue if none is given. */
  public static final double USUAL_POISSON = 0.4;

  private static final String YOUNG = "young:";
  private static final String POISSON = "poisson:";
  private static final double PASCAL_PER_MEGAPASCAL = 1e6;

  /**
   * Checks the ranges.
   *
   * @throws IllegalArgumentException if a figure is out of range
   */
  public ElasticMaterial {
    if (!isInRange(youngPascal, poisson)) {
      throw new IllegalArgumentException(
          "modulus must be 10 to 1e12 Pa and Poisson's ratio 0 to 0.49: youngPascal="
              + youngPascal
              + " poisson="
              + poisson);
    }
  }

  /**
   * Reads {@code young:PA} or {@code young:PA,poisson:NU}.
   *
   * @param text the text of a user; PA is Young's modulus in Pa, and NU is Poisson's ratio
   * @param number reads a number, or returns NaN
   * @return the material; empty if the text has another form or a figure is out of range
   */
  public static Optional<ElasticMaterial> parse(String text, ToDoubleFunction<String> number) {
    String[] parts = text.split(",", -1);
    boolean isKnown =
        parts[0].startsWith(YOUNG)
            && (parts.length == 1 || (parts.length == 2 && parts[1].startsWith(POISSON)));
    if (!isKnown) {
      return Optional.empty();
    }
    double young = number.applyAsDouble(parts[0].substring(YOUNG.length()));
    double ratio =
        parts.length == 1
            ? USUAL_POISSON
            : number.applyAsDouble(parts[1].substring(POISSON.length()));
    return isInRange(young, ratio)
        ? Optional.of(new ElasticMaterial(young, ratio))
        : Optional.empty();
  }

  private static boolean isInRange(double young, double ratio) {
    return young >= LEAST_YOUNG_PASCAL
        && young <= MOST_YOUNG_PASCAL
        && ratio >= 0
        && ratio <= MOST_POISSON;
  }

  /** {@return Young's modulus, N/mm^2} */
  public double youngNewtonPerMm2() {
    return youngPascal / PASCAL_PER_MEGAPASCAL;
  }
}
