package org.palpate.elastic.lattice;

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

  private static final double PASCAL_PER_MEGAPASCAL = 1e6;

  /**
   * Checks the ranges.
   *
   * @throws IllegalArgumentException if a figure is out of range
   */
  public ElasticMaterial {
    if (!(youngPascal >= LEAST_YOUNG_PASCAL && youngPascal <= MOST_YOUNG_PASCAL)
        || !(poisson >= 0 && poisson <= MOST_POISSON)) {
      throw new IllegalArgumentException(
          "modulus must be 10 to 1e12 Pa and Poisson's ratio 0 to 0.49: youngPascal="
              + youngPascal
              + " poisson="
              + poisson);
    }
  }

  /** Returns Young's modulus, N/mm^2. */
  public double youngNewtonPerMm2() {
    return youngPascal / PASCAL_PER_MEGAPASCAL;
  }
}
