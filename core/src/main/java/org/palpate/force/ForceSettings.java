package org.palpate.force;

/**
 * What a surface feels like.
 *
 * @param stiffnessNewtonPerMm k, N per mm of scan, at least 0 and finite
 * @param friction mu, at least 0 and finite
 * @param form how friction is computed
 * @param skipsFriction whether friction is left out where mu is 0 or nothing slid; the force is the
 *     same either way
 */
public record ForceSettings(
    double stiffnessNewtonPerMm, double friction, FrictionForm form, boolean skipsFriction) {

  /** Stiffness for a device that has no maximum of its own, N/mm. */
  public static final double DEFAULT_STIFFNESS_NEWTON_PER_MM = 0.5;

  public static final double DEFAULT_FRICTION = 0.2;

  /** Checks the ranges. */
  public ForceSettings {
    checkRange("stiffnessNewtonPerMm", stiffnessNewtonPerMm);
    checkRange("friction", friction);
  }

  /** By equation (4), with friction skipped where it is nothing. */
  public static ForceSettings of(double stiffnessNewtonPerMm, double friction) {
    return new ForceSettings(stiffnessNewtonPerMm, friction, FrictionForm.EQUATION_4, true);
  }

  private static void checkRange(String name, double value) {
    if (!(value >= 0) || Double.isInfinite(value)) {
      throw new IllegalArgumentException(
          name + " must be at least 0 and finite: " + name + "=" + value);
    }
  }
}
