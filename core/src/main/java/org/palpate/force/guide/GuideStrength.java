package org.palpate.force.guide;

import java.util.OptionalDouble;
import org.palpate.force.EffectSite;

/**
 * The strength of guides.
 *
 * @param stiffnessNewtonPerMm pull per distance, N/mm; if empty, half the stiffness of contact
 * @param maxNewton the largest pull of a guide, N; if empty, {@link #DEFAULT_MAX_NEWTON}
 * @param rangeMm the distance beyond which a guide does not pull, mm; infinity for none
 */
public record GuideStrength(
    OptionalDouble stiffnessNewtonPerMm, OptionalDouble maxNewton, double rangeMm) {
  /** The largest pull of a guide unless a user chooses another, N. */
  public static final double DEFAULT_MAX_NEWTON = 2;

  /** The default strength without a range. */
  public static final GuideStrength STANDARD =
      new GuideStrength(OptionalDouble.empty(), OptionalDouble.empty(), Double.POSITIVE_INFINITY);

  private static final double DEFAULT_FRACTION = 0.5;

  /** Returns the spring of positions in a frame. */
  GuideSpring spring(EffectSite site) {
    return new GuideSpring(newtonPerMm(site), mostNewton(site), rangeMm);
  }

  /** Returns the spring of depths, which has no range. */
  GuideSpring push(EffectSite site) {
    return new GuideSpring(newtonPerMm(site), mostNewton(site), Double.POSITIVE_INFINITY);
  }

  /**
   * Returns the spring of rotations. Its stiffness and that of the spring of positions have the
   * same ratio as the two stiffnesses of the coupling. It does not pull beyond half a turn.
   */
  GuideSpring turnSpring(EffectSite site) {
    double leverMm = site.leverMm();
    return new GuideSpring(
        newtonPerMm(site) * leverMm * leverMm, mostNewton(site) * leverMm, Math.PI);
  }

  private double newtonPerMm(EffectSite site) {
    return stiffnessNewtonPerMm.orElse(DEFAULT_FRACTION * site.stiffnessNewtonPerMm());
  }

  private double mostNewton(EffectSite site) {
    return Math.min(maxNewton.orElse(DEFAULT_MAX_NEWTON), site.maxForceNewton());
  }
}
