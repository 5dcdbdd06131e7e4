package org.palpate.force.guide;

import org.palpate.geometry.Vec3;

/**
 * A straight line.
 *
 * @param through a position on it, mm
 * @param direction its unit direction
 */
public record LineShape(Vec3 through, Vec3 direction) implements GuideShape {
  @Override
  public void nearest(Vec3 position, Vec3 dest) {
    position.sub(through, dest);
    direction.mul(dest.dot(direction), dest).add(through, dest);
  }
}
