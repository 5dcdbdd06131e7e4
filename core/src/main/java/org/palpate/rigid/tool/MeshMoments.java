package org.palpate.rigid.tool;

import org.palpate.geometry.Vec3;

/**
 * Sums the moments of a mesh: of the solid, as signed tetrahedra from an origin, or of the surface.
 *
 * <p>The second moment of a simplex with corners p_i is its size times ((sum p_i)(sum p_i)^T + sum
 * p_i p_i^T) / ((n + 1)(n + 2)) for n + 1 corners. One thread.
 */
final class MeshMoments {
  private final Vec3 origin;
  private double size;
  private final double[] first = new double[3];

  /** The second moments xx, yy, zz, xy, xz, yz about the origin. */
  private final double[] second = new double[6];

  private final double[][] p = new double[3][3];

  MeshMoments(Vec3 origin) {
    this.origin = origin;
  }

  /**
   * Adds the tetrahedron from the origin to a triangle. Its volume is negative if the triangle
   * faces the origin.
   */
  void addTetrahedron(Vec3 a, Vec3 b, Vec3 c) {
    setCorners(a, b, c);
    double volume =
        (p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1])
                + p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2])
                + p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]))
            / 6;
    add(volume, 4);
  }

  /** Adds a triangle as a sheet. */
  void addTriangle(Vec3 a, Vec3 b, Vec3 c) {
    setCorners(a, b, c);
    add(TriangleMath.area(a, b, c), 3);
  }

  /** Returns the signed volume, mm^3, or the area, mm^2, of all parts. */
  double size() {
    return size;
  }

  private void setCorners(Vec3 a, Vec3 b, Vec3 c) {
    for (int axis = 0; axis < 3; axis++) {
      p[0][axis] = a.get(axis) - origin.get(axis);
      p[1][axis] = b.get(axis) - origin.get(axis);
      p[2][axis] = c.get(axis) - origin.get(axis);
    }
  }

  /** Adds a simplex with a number of corners, of which one may be the origin. */
  private void add(double part, int corners) {
    size += part;
    for (int axis = 0; axis < 3; axis++) {
      first[axis] += part * sum(axis) / corners;
    }
    double scale = part / (corners * (corners + 1.0));
    second[0] += scale * product(0, 0);
    second[1] += scale * product(1, 1);
    second[2] += scale * product(2, 2);
    second[3] += scale * product(0, 1);
    second[4] += scale * product(0, 2);
    second[5] += scale * product(1, 2);
  }

  private double sum(int axis) {
    return p[0][axis] + p[1][axis] + p[2][axis];
  }

  private double product(int a, int b) {
    return sum(a) * sum(b) + p[0][a] * p[0][b] + p[1][a] * p[1][b] + p[2][a] * p[2][b];
  }

  /** Returns the properties of all parts; their centroid is the origin if they have no size. */
  MassProperties massProperties() {
    if (size == 0) {
      return new MassProperties(0, origin, new double[6]);
    }
    double x = first[0] / size;
    double y = first[1] / size;
    double z = first[2] / size;
    Vec3 centroid = new Vec3(x, y, z).add(origin, new Vec3());
    return new MassProperties(
        size,
        centroid,
        Math.max(0, second[0] / size - x * x),
        Math.max(0, second[1] / size - y * y),
        Math.max(0, second[2] / size - z * z),
        second[3] / size - x * y,
        second[4] / size - x * z,
        second[5] / size - y * z);
  }
}
