package org.palpate.force;

/** How friction is computed. */
public enum FrictionForm {
  /** sqrt(|Fc|^2 - (Fc.v/|v|)^2), what equation (4) says. */
  EQUATION_4,
  /**
   * |Fc| - |Fc.v/|v||, which the paper gives as easier; not equal to it: at 45 degrees 0.29 against
   * 0.71 of |Fc|. For comparison.
   */
  SHORTER,
  /** Static and sliding friction with a cone each; see {@link ConeFriction}. */
  CONE;

  /** Sliding friction over that at rest, where only one is given. */
  public double slidingShare() {
    return this == CONE ? ConeFriction.SLIDING_SHARE : 1;
  }
}
