package org.palpate.reduction;

import java.util.List;
import org.palpate.geometry.Vec3;

/**
 * The ball around all bodies, outside of which a free hand goes from one side to another. World mm.
 */
final class BallAround {
  /** The distance of a path around the bodies, as a multiple of that of the farthest point. */
  private static final double AROUND = 1.15;

  /** The number of points that {@link #between} returns. */
  static final int POINTS_BETWEEN = 3;

  /** Unit vectors are opposite if the length of their sum is less. */
  private static final double OPPOSITE = 1e-6;

  private final Vec3 middle = new Vec3();
  private final double radiusMm;
  private double aroundMm;

  /**
   * Creates the ball around points.
   *
   * @param points at least one; the ball is about their mean
   */
  BallAround(List<Vec3> points) {
    points.forEach(point -> middle.add(point, middle));
    middle.mul(1.0 / points.size(), middle);
    double farMm = 0;
    for (Vec3 point : points) {
      farMm = Math.max(farMm, point.sub(middle, new Vec3()).length());
    }
    radiusMm = farMm;
    reachTo(farMm);
  }

  /** Lets paths around lead outside of what reaches so far from the middle, and of the ball. */
  void reachTo(double farMm) {
    aroundMm = AROUND * Math.max(radiusMm, farMm);
  }

  Vec3 middle() {
    return middle;
  }

  double radiusMm() {
    return radiusMm;
  }

  /** Returns the point of a path around that lies in a direction from the middle. */
  Vec3 outside(Vec3 direction) {
    Vec3 far = direction.mul(aroundMm / direction.length(), new Vec3());
    return far.add(middle, far);
  }

  /** Returns the direction from the middle to a point, a unit vector; any one at the middle. */
  Vec3 away(Vec3 point) {
    Vec3 offset = point.sub(middle, new Vec3());
    return offset.length() > 0 ? unit(offset) : new Vec3(0, 0, 1);
  }

  /** Returns the point outside at which a ray leaves the ball; its direction is a unit vector. */
  Vec3 beyond(Vec3 from, Vec3 direction) {
    Vec3 offset = from.sub(middle, new Vec3());
    double along = offset.dot(direction);
    double r = aroundMm;
    double root = Math.sqrt(Math.max(0, along * along - offset.dot(offset) + r * r));
    return direction.mul(root - along, new Vec3()).add(from, new Vec3());
  }

  /**
   * Returns {@link #POINTS_BETWEEN} points outside between two that lie outside. All lie at equal
   * angles on an arc.
   */
  List<Vec3> between(Vec3 from, Vec3 to) {
    Vec3 begin = away(from);
    Vec3 end = away(to);
    Vec3 half = half(begin, end);
    return List.of(outside(half(begin, half)), outside(half), outside(half(half, end)));
  }

  /** Returns the unit vector half way between two, or a perpendicular one if they are opposite. */
  private static Vec3 half(Vec3 one, Vec3 other) {
    Vec3 sum = one.add(other, new Vec3());
    return unit(sum.length() < OPPOSITE ? one.cross(WayOut.beside(one), sum) : sum);
  }

  private static Vec3 unit(Vec3 vector) {
    return vector.mul(1 / vector.length(), vector);
  }
}
