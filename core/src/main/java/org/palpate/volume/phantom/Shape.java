package org.palpate.volume.phantom;

import org.palpate.geometry.Vec3;

/**
 * A body as a function of the point, in grid coordinates: at most 0 inside, positive outside, and
 * never changing faster than the point moves. So its absolute value is at most the distance to the
 * surface, which lets whole bricks be decided at once.
 */
interface Shape {
  double at(double x, double y, double z);

  /** The points at least {@code depth} below the surface, by this function's own measure. */
  default Shape shrunk(double depth) {
    return (x, y, z) -> at(x, y, z) + depth;
  }

  /** A ball; exact distance. */
  static Shape ball(Vec3 centre, double radius) {
    return (x, y, z) -> norm(x - centre.x, y - centre.y, z - centre.z) - radius;
  }

  /** An ellipsoid along the axes; its value is no distance but bounded by it. */
  static Shape ellipsoid(Vec3 centre, Vec3 radii) {
    double least = Math.min(radii.x, Math.min(radii.y, radii.z));
    Vec3 scale = new Vec3(1 / radii.x, 1 / radii.y, 1 / radii.z);
    return (x, y, z) -> {
      double u = (x - centre.x) * scale.x;
      double v = (y - centre.y) * scale.y;
      double w = (z - centre.z) * scale.z;
      return (norm(u, v, w) - 1) * least;
    };
  }

  /** What lies behind the plane through {@code point} with the unit vector {@code normal}. */
  static Shape halfSpace(Vec3 point, Vec3 normal) {
    double offset = normal.dot(point);
    return (x, y, z) -> normal.x * x + normal.y * y + normal.z * z - offset;
  }

  /** A ring round the z axis through {@code centre}; exact distance. */
  static Shape torus(Vec3 centre, double ringRadius, double tubeRadius) {
    return (x, y, z) -> {
      double u = x - centre.x;
      double v = y - centre.y;
      double w = z - centre.z;
      double fromRing = Math.sqrt(u * u + v * v) - ringRadius;
      return Math.sqrt(fromRing * fromRing + w * w) - tubeRadius;
    };
  }

  /** All that is within {@code radius} of a straight line from {@code a} to {@code b}; exact. */
  static Shape capsule(Vec3 a, Vec3 b, double radius) {
    Vec3 axis = b.sub(a, new Vec3());
    double squared = axis.dot(axis);
    return (x, y, z) -> {
      double u = x - a.x;
      double v = y - a.y;
      double w = z - a.z;
      double along = (u * axis.x + v * axis.y + w * axis.z) / squared;
      double t = Math.max(0, Math.min(1, along));
      return norm(u - t * axis.x, v - t * axis.y, w - t * axis.z) - radius;
    };
  }

  /** An upright cylinder between two heights. */
  static Shape cylinder(Vec3 bottom, double height, double radius) {
    double half = height / 2;
    return (x, y, z) -> {
      double u = x - bottom.x;
      double v = y - bottom.y;
      double fromMiddle = Math.abs(z - bottom.z - half) - half;
      return Math.max(Math.sqrt(u * u + v * v) - radius, fromMiddle);
    };
  }

  private static double norm(double x, double y, double z) {
    return Math.sqrt(x * x + y * y + z * z);
  }
}
