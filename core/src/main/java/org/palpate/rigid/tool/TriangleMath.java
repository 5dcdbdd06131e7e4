package org.palpate.rigid.tool;

import org.palpate.geometry.Vec3;

/** Lengths and areas of triangles, mm. Any thread. */
final class TriangleMath {
  private TriangleMath() {}

  /** Returns the area of a triangle, mm^2. */
  static double area(Vec3 a, Vec3 b, Vec3 c) {
    double ux = b.x - a.x;
    double uy = b.y - a.y;
    double uz = b.z - a.z;
    double vx = c.x - a.x;
    double vy = c.y - a.y;
    double vz = c.z - a.z;
    double x = uy * vz - uz * vy;
    double y = uz * vx - ux * vz;
    double z = ux * vy - uy * vx;
    return 0.5 * Math.sqrt(x * x + y * y + z * z);
  }

  /** Returns the squared distance of two points, mm^2. */
  static double squaredDistance(Vec3 a, Vec3 b) {
    double x = b.x - a.x;
    double y = b.y - a.y;
    double z = b.z - a.z;
    return x * x + y * y + z * z;
  }
}
