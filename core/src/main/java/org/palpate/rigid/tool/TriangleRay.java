package org.palpate.rigid.tool;

import java.math.BigDecimal;
import org.palpate.geometry.Vec3;

/**
 * Decides exactly whether a line parallel to z meets a triangle, and whether the triangle lies
 * below a point of that line. Floating point decides if its error bound allows it, and else
 * rational arithmetic.
 *
 * <p>Ties are decided as if the line were moved by an infinitely small amount along x, by a much
 * smaller one along y, and the point upwards by a larger one. Then a line meets exactly one of two
 * triangles that share an edge. Reference: Edelsbrunner and Muecke, Simulation of simplicity, 1990.
 * One thread.
 */
final class TriangleRay {
  /** Bounds of the relative error of the two determinants, after Shewchuk 1997, rounded up. */
  private static final double ERROR_2D = 8 * 0x1p-53;

  private static final double ERROR_3D = 32 * 0x1p-53;

  /** Below this, products may be subnormal and the bounds do not hold. */
  private static final double LEAST_SAFE = 0x1p-900;

  private final Vec3[] p = {new Vec3(), new Vec3(), new Vec3()};
  private int facing;

  /** Sets the triangle, mm. */
  void set(Vec3 a, Vec3 b, Vec3 c) {
    p[0].set(a);
    p[1].set(b);
    p[2].set(c);
    facing = orientation(a, b, c.x, c.y);
  }

  double lowX() {
    return Math.min(p[0].x, Math.min(p[1].x, p[2].x));
  }

  double highX() {
    return Math.max(p[0].x, Math.max(p[1].x, p[2].x));
  }

  double lowY() {
    return Math.min(p[0].y, Math.min(p[1].y, p[2].y));
  }

  double highY() {
    return Math.max(p[0].y, Math.max(p[1].y, p[2].y));
  }

  /**
   * Returns 1 if the line through x, y meets the triangle and the triangle faces up, -1 if it meets
   * it and the triangle faces down, and 0 if it does not meet it.
   */
  int crossing(double x, double y) {
    if (facing == 0) {
      return 0;
    }
    boolean isInside = false;
    for (int n = 0; n < 3; n++) {
      isInside ^= isRightOf(p[n], p[(n + 1) % 3], x, y);
    }
    return isInside ? facing : 0;
  }

  /** Whether an edge passes the point on the side of larger x. */
  private static boolean isRightOf(Vec3 a, Vec3 b, double x, double y) {
    if ((a.y <= y) == (b.y <= y)) {
      return false;
    }
    boolean isRising = a.y < b.y;
    int side = isRising ? orientation(a, b, x, y) : orientation(b, a, x, y);
    return side > 0; // on the edge, the point is moved towards larger x
  }

  /** Returns the sign of the area of a, b and (x, y) in the plane: 1 if counter-clockwise. */
  private static int orientation(Vec3 a, Vec3 b, double x, double y) {
    double left = (b.x - a.x) * (y - a.y);
    double right = (b.y - a.y) * (x - a.x);
    double value = left - right;
    double size = Math.abs(left) + Math.abs(right);
    if (Math.abs(value) > ERROR_2D * size && size > LEAST_SAFE) {
      return value > 0 ? 1 : -1;
    }
    BigDecimal exactLeft = difference(b.x, a.x).multiply(difference(y, a.y));
    BigDecimal exactRight = difference(b.y, a.y).multiply(difference(x, a.x));
    return exactLeft.compareTo(exactRight);
  }

  private static BigDecimal difference(double a, double b) {
    return new BigDecimal(a).subtract(new BigDecimal(b));
  }

  /** Returns a first guess of the z of the triangle at x, y. */
  double height(double x, double y) {
    double ux = p[1].x - p[0].x;
    double uy = p[1].y - p[0].y;
    double vx = p[2].x - p[0].x;
    double vy = p[2].y - p[0].y;
    double area = ux * vy - uy * vx;
    double s = ((x - p[0].x) * vy - (y - p[0].y) * vx) / area;
    double t = (ux * (y - p[0].y) - uy * (x - p[0].x)) / area;
    double z = p[0].z + s * (p[1].z - p[0].z) + t * (p[2].z - p[0].z);
    return Double.isFinite(z) ? z : p[0].z;
  }

  /** Whether the plane of the triangle, which the line meets, lies below the point or in it. */
  boolean isBelow(double x, double y, double z) {
    double ax = p[0].x - x;
    double ay = p[0].y - y;
    double az = p[0].z - z;
    double bx = p[1].x - x;
    double by = p[1].y - y;
    double bz = p[1].z - z;
    double cx = p[2].x - x;
    double cy = p[2].y - y;
    double cz = p[2].z - z;
    double bc = bx * cy - by * cx;
    double ca = cx * ay - cy * ax;
    double ab = ax * by - ay * bx;
    double value = az * bc + bz * ca + cz * ab;
    double size =
        Math.abs(az) * (Math.abs(bx * cy) + Math.abs(by * cx))
            + Math.abs(bz) * (Math.abs(cx * ay) + Math.abs(cy * ax))
            + Math.abs(cz) * (Math.abs(ax * by) + Math.abs(ay * bx));
    boolean isSure = Math.abs(value) > ERROR_3D * size && size > LEAST_SAFE;
    int sign = isSure ? (value > 0 ? 1 : -1) : exactHeight(x, y, z);
    return sign * facing <= 0;
  }

  /** Returns the sign of the same determinant in rational arithmetic. */
  private int exactHeight(double x, double y, double z) {
    BigDecimal[][] d = new BigDecimal[3][];
    for (int n = 0; n < 3; n++) {
      d[n] = new BigDecimal[] {difference(p[n].x, x), difference(p[n].y, y), difference(p[n].z, z)};
    }
    return d[0][2]
        .multiply(minor(d[1], d[2]))
        .add(d[1][2].multiply(minor(d[2], d[0])))
        .add(d[2][2].multiply(minor(d[0], d[1])))
        .signum();
  }

  private static BigDecimal minor(BigDecimal[] a, BigDecimal[] b) {
    return a[0].multiply(b[1]).subtract(a[1].multiply(b[0]));
  }
}
