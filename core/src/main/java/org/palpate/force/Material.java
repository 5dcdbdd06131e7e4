package org.palpate.force;

/**
 * The material of one object.
 *
 * @param stiffnessNewtonPerMm k, N per mm of scan
 * @param staticFriction mu at rest; only {@link FrictionForm#CONE} uses it
 * @param slidingFriction mu of a slide, at most the static one
 * @param dampingNewtonSecondPerMm force per speed of the hand along the coupling; see {@link
 *     ContactDamping}
 */
public record Material(
    double stiffnessNewtonPerMm,
    double staticFriction,
    double slidingFriction,
    double dampingNewtonSecondPerMm) {

  /**
   * Checks that each figure is finite and at least 0.
   *
   * @throws IllegalArgumentException if a figure is out of range, or sliding friction exceeds
   *     static friction
   */
  public Material {
    checkRange("stiffnessNewtonPerMm", stiffnessNewtonPerMm);
    checkRange("staticFriction", staticFriction);
    checkRange("slidingFriction", slidingFriction);
    checkRange("dampingNewtonSecondPerMm", dampingNewtonSecondPerMm);
    if (slidingFriction > staticFriction) {
      throw new IllegalArgumentException(
          "sliding friction must not be larger than static friction: slidingFriction="
              + slidingFriction
              + " staticFriction="
              + staticFriction);
    }
  }

  /**
   * {@return a material without damping, with the sliding friction that suits the form}
   *
   * @param stiffnessNewtonPerMm k, N/mm
   * @param friction the static mu
   * @param form the formula of friction, which gives the sliding mu
   */
  public static Material of(double stiffnessNewtonPerMm, double friction, FrictionForm form) {
    return new Material(stiffnessNewtonPerMm, friction, form.slidingFraction() * friction, 0);
  }

  /** Returns this material with its stiffness multiplied and friction added, at least 0. */
  Material retuned(double stiffnessFactor, double addedFriction) {
    double newStatic = Math.max(0, staticFriction + addedFriction);
    double slidingFraction = staticFriction > 0 ? slidingFriction / staticFriction : 1;
    return new Material(
        stiffnessFactor * stiffnessNewtonPerMm,
        newStatic,
        Math.min(newStatic, slidingFraction * newStatic),
        dampingNewtonSecondPerMm);
  }

  private static void checkRange(String name, double value) {
    if (!(value >= 0) || Double.isInfinite(value)) {
      throw new IllegalArgumentException(
          name + " must be at least 0 and finite: " + name + "=" + value);
    }
  }
}
