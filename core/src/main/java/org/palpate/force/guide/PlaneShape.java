package org.palpate.force.guide;

import org.palpate.geometry.Vec3;

/**
 * A plane.
 *
 * @param through a position in it, mm
 * @param normal its unit normal
 */
public record PlaneShape(Vec3 through, Vec3 normal) implements GuideShape {
  @Override
  public void nearest(Vec3 position, Vec3 dest) {
    double x = position.x;
    double y = position.y;
    double z = position.z;
    double height = position.sub(through, dest).dot(normal);
    dest.set(x - height * normal.x, y - height * normal.y, z - height * normal.z);
  }
}
