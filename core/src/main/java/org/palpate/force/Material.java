package org.palpate.force;

/**
 * What one object feels like.
 *
 * @param stiffnessNewtonPerMm k, N per mm of scan
 * @param stickingFriction mu at rest; for {@link FrictionForm#CONE} alone
 * @param slidingFriction mu of a slide, at most that at rest
 * @param dampingNewtonSecondPerMm force against the speed at which the hand goes in or out; see
 *     {@link ContactDamping}
 */
public record Material(
    double stiffnessNewtonPerMm,
    double stickingFriction,
    double slidingFriction,
    double dampingNewtonSecondPerMm) {

  /** Checks the ranges: all at least 0 and finite. */
  public Material {
    checkRange("stiffnessNewtonPerMm", stiffnessNewtonPerMm);
    checkRange("friction", stickingFriction);
    checkRange("slidingFriction", slidingFriction);
    checkRange("dampingNewtonSecondPerMm", dampingNewtonSecondPerMm);
    if (slidingFriction > stickingFriction) {
      throw new IllegalArgumentException(
          "sliding friction must not be above that at rest: slidingFriction="
              + slidingFriction
              + " stickingFriction="
              + stickingFriction);
    }
  }

  /** Without damping, and with the sliding friction that goes with a form of friction. */
  public static Material of(double stiffnessNewtonPerMm, double friction, FrictionForm form) {
    return new Material(stiffnessNewtonPerMm, friction, form.slidingShare() * friction, 0);
  }

  /** Stiffer by a factor, rougher by a summand; no friction goes below 0. */
  Material retuned(double stiffnessFactor, double moreFriction) {
    double sticking = Math.max(0, stickingFriction + moreFriction);
    double share = stickingFriction > 0 ? slidingFriction / stickingFriction : 1;
    return new Material(
        stiffnessFactor * stiffnessNewtonPerMm,
        sticking,
        Math.min(sticking, share * sticking),
        dampingNewtonSecondPerMm);
  }

  private static void checkRange(String name, double value) {
    if (!(value >= 0) || Double.isInfinite(value)) {
      throw new IllegalArgumentException(
          name + " must be at least 0 and finite: " + name + "=" + value);
    }
  }
}
