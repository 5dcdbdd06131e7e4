package org.palpate.force.guide;

import java.util.ArrayList;
import java.util.List;
import org.palpate.force.EffectPlan;
import org.palpate.geometry.Vec3;

/** Plans of guides, in world mm. Directions need not have the length 1. Any thread. */
public final class Guides {
  private Guides() {}

  /** Returns the plan of a guide that keeps the hand on a straight line. */
  public static EffectPlan axis(Vec3 through, Vec3 direction, GuideStrength strength) {
    Vec3 unit = unit(direction);
    return site ->
        new PositionGuide(
            new LineShape(site.position(through), site.direction(unit)), strength.spring(site));
  }

  /** Returns the plan of a guide that keeps the hand in a plane. */
  public static EffectPlan plane(Vec3 through, Vec3 normal, GuideStrength strength) {
    Vec3 unit = unit(normal);
    return site ->
        new PositionGuide(
            new PlaneShape(site.position(through), site.direction(unit)), strength.spring(site));
  }

  /** Returns the plan of a guide that keeps the hand in a ball. */
  public static EffectPlan ball(Vec3 centre, double radiusMm, GuideStrength strength) {
    return site ->
        new PositionGuide(new BallShape(site.position(centre), radiusMm), strength.spring(site));
  }

  /**
   * Returns the plan of a guide that keeps the hand on a path of straight pieces; see {@link
   * PathShape}.
   */
  public static EffectPlan path(List<Vec3> positions, GuideStrength strength) {
    return site -> {
      List<Vec3> inFrame = new ArrayList<>();
      positions.forEach(position -> inFrame.add(site.position(position)));
      return new PositionGuide(new PathShape(inFrame), strength.spring(site));
    };
  }

  /**
   * Returns the plan of a guide that lets what is held turn about an axis alone; see {@link
   * HingeGuide}.
   */
  public static EffectPlan hinge(Vec3 through, Vec3 direction, GuideStrength strength) {
    Vec3 unit = unit(direction);
    return site ->
        new HingeGuide(
            site.position(through),
            site.direction(unit),
            strength.spring(site),
            strength.turnSpring(site),
            site.leverMm());
  }

  /**
   * Returns the plan of a guide that turns the axis z of a rigid tool along a direction; see {@link
   * AlignGuide}.
   */
  public static EffectPlan align(Vec3 direction, GuideStrength strength) {
    Vec3 unit = unit(direction);
    return site -> new AlignGuide(site.direction(unit), strength.turnSpring(site));
  }

  /**
   * Returns the plan of a guide that pushes the tool out of a margin around a segment; see {@link
   * SegmentPush}.
   */
  public static EffectPlan away(SegmentDistance segment, double marginMm, GuideStrength strength) {
    return site -> new SegmentPush(segment, marginMm, strength.push(site)::newton, site);
  }

  /**
   * Returns the plan of a guide that pulls a body in hand to where it fits; see {@link FitGuide}.
   */
  public static EffectPlan fit(FitExchange fits, GuideStrength strength) {
    return site -> new FitGuide(fits, strength.spring(site));
  }

  private static Vec3 unit(Vec3 direction) {
    double length = direction.length();
    if (!(length > 0 && length < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("a direction needs a length: direction=" + direction);
    }
    return direction.mul(1 / length, new Vec3());
  }
}
