package org.palpate.volume.phantom;

import org.palpate.geometry.Vec3;

/**
 * A body as a function of a point in grid coordinates: at most 0 inside and positive outside.
 *
 * <p>Invariant: the value changes no faster than the point moves. So its absolute value is at most
 * the distance to the surface, and whole bricks can be decided at once.
 */
interface Shape {
  /** Returns the value at a point. */
  double at(double x, double y, double z);

  /** Returns the points whose value is at most {@code -depth}. */
  default Shape shrunk(double depth) {
    return (x, y, z) -> at(x, y, z) + depth;
  }

  /** Returns a ball; its value is the exact distance. */
  static Shape ball(Vec3 centre, double radius) {
    return (x, y, z) -> norm(x - centre.x, y - centre.y, z - centre.z) - radius;
  }

  /** Returns an ellipsoid along the axes; its value is at most the distance. */
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

  /** Returns the half-space behind the plane through {@code point} with a unit normal. */
  static Shape halfSpace(Vec3 point, Vec3 normal) {
    double offset = normal.dot(point);
    return (x, y, z) -> normal.x * x + normal.y * y + normal.z * z - offset;
  }

  /** Returns a torus around the z axis through {@code centre}; its value is the exact distance. */
  static Shape torus(Vec3 centre, double ringRadius, double tubeRadius) {
    return (x, y, z) -> {
      double u = x - centre.x;
      double v = y - centre.y;
      double w = z - centre.z;
      double fromRing = Math.sqrt(u * u + v * v) - ringRadius;
      return Math.sqrt(fromRing * fromRing + w * w) - tubeRadius;
    };
  }

  /** Returns all points within {@code radius} of the segment from a to b; the exact distance. */
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

  /** Returns an upright cylinder on {@code bottom}; its value is at most the distance. */
  static Shape cylinder(Vec3 bottom, double height, double radius) {
    double half = height / 2;
    return (x, y, z) -> {
      double u = x - bottom.x;
      double v = y - bottom.y;
      double fromMiddle = Math.abs(z - bottom.z - half) - half;
      return Math.max(Math.sqrt(u * u + v * v) - radius, fromMiddle);
    };
  }

  /** Returns a box between two corners; its value is at most the distance. */
  static Shape box(Vec3 low, Vec3 high) {
    Vec3 centre = low.add(high, new Vec3());
    centre.mul(0.5, centre);
    return (x, y, z) ->
        Math.max(
            Math.abs(x - centre.x) - (high.x - centre.x),
            Math.max(
                Math.abs(y - centre.y) - (high.y - centre.y),
                Math.abs(z - centre.z) - (high.z - centre.z)));
  }

  private static double norm(double x, double y, double z) {
    return Math.sqrt(x * x + y * y + z * z);
  }
}
