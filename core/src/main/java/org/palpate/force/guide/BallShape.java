package org.palpate.force.guide;

import org.palpate.geometry.Vec3;

/**
 * A ball, with all positions inside it.
 *
 * @param centre its centre, mm
 * @param radiusMm its radius, mm, positive
 */
public record BallShape(Vec3 centre, double radiusMm) implements GuideShape {
  @Override
  public void nearest(Vec3 position, Vec3 dest) {
    double x = position.x;
    double y = position.y;
    double z = position.z;
    double distance = position.sub(centre, dest).length();
    if (distance > radiusMm) {
      dest.mul(radiusMm / distance, dest).add(centre, dest);
    } else {
      dest.set(x, y, z);
    }
  }
}
