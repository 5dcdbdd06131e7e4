package org.palpate.force.guide;

import java.util.ArrayList;
import java.util.List;
import org.palpate.force.EffectPlan;
import org.palpate.geometry.Vec3;

/** Plans of guides, in world mm. Directions need not have the length 1. Any thread. */
public final class Guides {
  private Guides() {}

  /**
   * {@return the plan of a guide that keeps the hand on a straight line}
   *
   * @param through a position on the line, world mm
   * @param direction the direction of the line, in the world
   * @param strength the spring of the guide
   */
  public static EffectPlan axis(Vec3 through, Vec3 direction, GuideStrength strength) {
    Vec3 unit = unit(direction);
    return site ->
        new PositionGuide(
            new LineShape(site.position(through), site.direction(unit)), strength.spring(site));
  }

  /**
   * {@return the plan of a guide that keeps the hand in a plane}
   *
   * @param through a position in the plane, world mm
   * @param normal the normal of the plane, in the world
   * @param strength the spring of the guide
   */
  public static EffectPlan plane(Vec3 through, Vec3 normal, GuideStrength strength) {
    Vec3 unit = unit(normal);
    return site ->
        new PositionGuide(
            new PlaneShape(site.position(through), site.direction(unit)), strength.spring(site));
  }

  /**
   * {@return the plan of a guide that keeps the hand in a ball}
   *
   * @param centre the centre of the ball, world mm
   * @param radiusMm the radius of the ball, mm
   * @param strength the spring of the guide
   */
  public static EffectPlan ball(Vec3 centre, double radiusMm, GuideStrength strength) {
    return site ->
        new PositionGuide(new BallShape(site.position(centre), radiusMm), strength.spring(site));
  }

  /**
   * {@return the plan of a guide that keeps the hand on a path of straight pieces; see {@link
   * PathShape}}
   *
   * @param positions the ends of the pieces in order, world mm, 2 to {@link
   *     PathShape#MOST_POSITIONS}
   * @param strength the spring of the guide
   */
  public static EffectPlan path(List<Vec3> positions, GuideStrength strength) {
    return site -> {
      List<Vec3> inFrame = new ArrayList<>();
      positions.forEach(position -> inFrame.add(site.position(position)));
      return new PositionGuide(new PathShape(inFrame), strength.spring(site));
    };
  }

  /**
   * {@return the plan of a guide that lets what is held turn about an axis alone; see {@link
   * HingeGuide}}
   *
   * @param through a position on the axis, world mm
   * @param direction the direction of the axis, in the world
   * @param strength the springs of positions and of rotations
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
   * {@return the plan of a guide that turns the axis z of a rigid tool along a direction; see
   * {@link AlignGuide}}
   *
   * @param direction the direction to which the axis is turned, in the world
   * @param strength the spring of rotations
   */
  public static EffectPlan align(Vec3 direction, GuideStrength strength) {
    Vec3 unit = unit(direction);
    return site -> new AlignGuide(site.direction(unit), strength.turnSpring(site));
  }

  /**
   * {@return the plan of a guide that pushes the tool out of a margin around a segment; see {@link
   * SegmentPush}}
   *
   * @param segment measures distances at least up to the margin
   * @param marginMm the width of the margin, mm
   * @param strength the push by depth; its range has no effect
   */
  public static EffectPlan away(SegmentDistance segment, double marginMm, GuideStrength strength) {
    return site -> new SegmentPush(segment, marginMm, strength.push(site)::newton, site);
  }

  /**
   * {@return the plan of a guide that pulls a body in hand to where it fits; see {@link FitGuide}}
   *
   * @param fits delivers the newest fit, perhaps none
   * @param strength the spring of the guide
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
