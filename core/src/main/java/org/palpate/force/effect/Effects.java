package org.palpate.force.effect;

import org.palpate.force.EffectPlan;
import org.palpate.force.EffectSite;
import org.palpate.force.guide.SegmentDistance;
import org.palpate.force.guide.SegmentPush;
import org.palpate.volume.ScalarVolume;

/**
 * Plans of effects. The force of each effect is at most the longest force of the frame. Any thread.
 */
public final class Effects {
  private Effects() {}

  /**
   * {@return the plan of an effect that resists every motion}
   *
   * @param newtonSecondPerMm force per speed, positive
   */
  public static EffectPlan viscosity(double newtonSecondPerMm) {
    return site -> new Viscosity(newtonSecondPerMm, site.maxForceNewton(), site.leverMm());
  }

  /**
   * {@return the plan of an effect that attracts the tool to a segment} The pull is greatest
   * half-way and small at the surface, so that it begins and ends without a step.
   *
   * @param segment measures at least up to the reach
   * @param newton the greatest pull, N, positive
   * @param reachMm the distance at which the pull begins, mm, positive
   */
  public static EffectPlan magnet(SegmentDistance segment, double newton, double reachMm) {
    return site -> {
      double most = limited(newton, site);
      return new SegmentPush(
          segment, reachMm, depth -> -4 * most * depth / reachMm * (1 - depth / reachMm), site);
    };
  }

  /**
   * {@return the plan of an effect that sticks to surfaces and slips}
   *
   * @param newton the pull at which the hand slips, N, positive
   */
  public static EffectPlan stickSlip(double newton) {
    return site -> new StickSlip(limited(newton, site), site.stiffnessNewtonPerMm());
  }

  /**
   * {@return the plan of an effect that shakes the hand in contact; it is active}
   *
   * @param hertz frequency, positive
   * @param newton amplitude, N, positive
   */
  public static EffectPlan vibration(double hertz, double newton) {
    return site -> new Vibration(hertz, limited(newton, site));
  }

  /**
   * {@return the plan of an effect that lets the hand feel the detail of grey values}
   *
   * @param grey the grey values whose detail is felt; kept
   * @param mmPerValue the height of a unit of detail, mm
   */
  public static EffectPlan texture(ScalarVolume grey, double mmPerValue) {
    return site -> new GreyTexture(grey, mmPerValue, site);
  }

  private static double limited(double newton, EffectSite site) {
    return Math.min(newton, site.maxForceNewton());
  }
}
