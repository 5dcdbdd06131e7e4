package org.palpate.force;

/** The formula of friction. */
public enum FrictionForm {
  /** Equation (4) of the paper: the pressing force is sqrt(|Fc|^2 - (Fc.v/|v|)^2). */
  EQUATION_4,
  /**
   * The shorter form that the paper also gives: the pressing force is |Fc| - |Fc.v/|v||. It is not
   * equal to equation (4): at 45 degrees it is 0.29 |Fc| instead of 0.71 |Fc|. For comparison.
   */
  SHORTER,
  /** Static and sliding friction with one cone each; see {@link ConeFriction}. */
  CONE;

  /** {@return sliding friction divided by static friction, if a user gives only one of them} */
  public double slidingFraction() {
    return this == CONE ? ConeFriction.SLIDING_FRACTION : 1;
  }
}
