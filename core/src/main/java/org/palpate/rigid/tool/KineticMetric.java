package org.palpate.rigid.tool;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * Distances between poses of one tool, mm: the root mean square displacement of its matter along
 * straight lines. A small twist (v, w) has the squared length |v|^2 + w.J w, where J is the inertia
 * about the reference point for unit mass.
 *
 * <p>Metric coordinates are y = (v, L^T w), with J = L L^T and w in the tool's axes. In them the
 * metric is the identity, so the nearest pose is a closest point. Immutable.
 */
public final class KineticMetric {
  /**
   * The fraction of the covariance's trace that is added to its diagonal, so that rods can be
   * turned.
   */
  private static final double ADDED_FRACTION = 0.01;

  /** The variance that is added too, mm^2, so that a tool of a single point has a metric. */
  private static final double LEAST_VARIANCE_MM2 = 1e-3;

  private final double xx;
  private final double yy;
  private final double zz;
  private final double xy;
  private final double xz;
  private final double yz;
  private final double rmsRadiusMm;

  // J = L L^T with the lower triangle L.
  private final double l00;
  private final double l10;
  private final double l11;
  private final double l20;
  private final double l21;
  private final double l22;

  /**
   * Creates the metric of matter with this covariance about the reference point.
   *
   * @param covariance xx, yy, zz, xy, xz, yz, mm^2
   */
  KineticMetric(double... covariance) {
    double trace = covariance[0] + covariance[1] + covariance[2];
    double added = ADDED_FRACTION * trace + LEAST_VARIANCE_MM2;
    rmsRadiusMm = Math.sqrt(trace);
    xx = covariance[0] + added;
    yy = covariance[1] + added;
    zz = covariance[2] + added;
    xy = covariance[3];
    xz = covariance[4];
    yz = covariance[5];
    l00 = Math.sqrt(yy + zz);
    l10 = -xy / l00;
    l11 = Math.sqrt(xx + zz - l10 * l10);
    l20 = -xz / l00;
    l21 = (-yz - l20 * l10) / l11;
    l22 = Math.sqrt(xx + yy - l20 * l20 - l21 * l21);
  }

  /** {@return the root mean square distance of the matter from the reference point, mm} */
  public double rmsRadiusMm() {
    return rmsRadiusMm;
  }

  /**
   * {@return w.J w of an angular speed in the tool's axes: twice its energy for unit mass}
   *
   * @param spin the angular speed in the tool's axes, rad/s
   */
  public double squaredSpin(Vec3 spin) {
    double x = l00 * spin.x + l10 * spin.y + l20 * spin.z;
    double y = l11 * spin.y + l21 * spin.z;
    double z = l22 * spin.z;
    return x * x + y * y + z * z;
  }

  /**
   * Writes J w: the inertia for unit mass, mm^2, times an angular speed.
   *
   * @param spin the angular speed w in the tool's axes, rad/s
   * @param dest receives the product, in the tool's axes; may be {@code spin}
   * @return {@code dest}
   */
  public Vec3 inertiaTimes(Vec3 spin, Vec3 dest) {
    return dest.set(
        (yy + zz) * spin.x - xy * spin.y - xz * spin.z,
        (xx + zz) * spin.y - xy * spin.x - yz * spin.z,
        (xx + yy) * spin.z - xz * spin.x - yz * spin.y);
  }

  /**
   * Writes the solution x of (m J + s I) x = b.
   *
   * @param m the factor of the inertia, at least 0
   * @param s added to the diagonal, at least 0; not both are 0
   * @param b the right side, in the tool's axes
   * @param dest receives the solution, in the tool's axes; may be {@code b}
   * @return {@code dest}
   */
  public Vec3 solve(double m, double s, Vec3 b, Vec3 dest) {
    double a00 = m * (yy + zz) + s;
    double a11 = m * (xx + zz) + s;
    double a22 = m * (xx + yy) + s;
    double c00 = Math.sqrt(a00);
    double c10 = -m * xy / c00;
    double c20 = -m * xz / c00;
    double c11 = Math.sqrt(a11 - c10 * c10);
    double c21 = (-m * yz - c20 * c10) / c11;
    double c22 = Math.sqrt(a22 - c20 * c20 - c21 * c21);
    double u = b.x / c00;
    double v = (b.y - c10 * u) / c11;
    double w = (b.z - c20 * u - c21 * v) / c22;
    double z = w / c22;
    double y = (v - c21 * z) / c11;
    return dest.set((u - c10 * y - c20 * z) / c00, y, z);
  }

  /**
   * {@return the squared distance between two poses, mm^2; exactly 0 for the same bits}
   *
   * @param a a pose of the tool, world mm
   * @param b another pose of the tool, world mm
   */
  public double squaredDistance(Pose a, Pose b) {
    double dx = b.translation.x - a.translation.x;
    double dy = b.translation.y - a.translation.y;
    double dz = b.translation.z - a.translation.z;
    return dx * dx + dy * dy + dz * dz + squaredTurn(a.rotation, b.rotation);
  }

  /**
   * {@return the distance between two poses, mm}
   *
   * @param a a pose of the tool, world mm
   * @param b another pose of the tool, world mm
   */
  public double distance(Pose a, Pose b) {
    return Math.sqrt(squaredDistance(a, b));
  }

  /**
   * Returns the trace of (R-I) C (R-I)^T, where R is the rotation from one to the other in the
   * tool's axes. Uses the quaternion of R, in which R-I has no cancellation.
   */
  private double squaredTurn(Quaternion a, Quaternion b) {
    double w = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
    // Grouped so that each pair cancels to 0 for the same bits.
    double x = (a.w * b.x - a.x * b.w) - (a.y * b.z - a.z * b.y);
    double y = (a.w * b.y - a.y * b.w) - (a.z * b.x - a.x * b.z);
    double z = (a.w * b.z - a.z * b.w) - (a.x * b.y - a.y * b.x);
    return squaredRow(-(y * y + z * z), x * y - w * z, x * z + w * y)
        + squaredRow(x * y + w * z, -(x * x + z * z), y * z - w * x)
        + squaredRow(x * z - w * y, y * z + w * x, -(x * x + y * y));
  }

  private double squaredRow(double a, double b, double c) {
    return 4 * (a * a * xx + b * b * yy + c * c * zz + 2 * (a * b * xy + a * c * xz + b * c * yz));
  }

  /**
   * Writes the metric coordinates of a twist.
   *
   * @param pose the tool's, whose rotation leads from tool to world axes
   * @param v displacement of the reference point, world mm
   * @param w rotation vector, world axes, rad
   * @param scratch overwritten
   * @param dest six metric coordinates, mm
   */
  public void toMetric(Pose pose, Vec3 v, Vec3 w, Vec3 scratch, double[] dest) {
    pose.rotation.inverseRotate(w, scratch);
    dest[0] = v.x;
    dest[1] = v.y;
    dest[2] = v.z;
    dest[3] = l00 * scratch.x + l10 * scratch.y + l20 * scratch.z;
    dest[4] = l11 * scratch.y + l21 * scratch.z;
    dest[5] = l22 * scratch.z;
  }

  /**
   * Writes the twist of six metric coordinates: the inverse of {@link #toMetric}.
   *
   * @param pose the pose of the tool, world mm
   * @param metric six metric coordinates, mm
   * @param v receives the displacement of the reference point, world mm
   * @param w receives the rotation vector, world axes, rad
   */
  public void toTwist(Pose pose, double[] metric, Vec3 v, Vec3 w) {
    v.set(metric[0], metric[1], metric[2]);
    double z = metric[5] / l22;
    double y = (metric[4] - l21 * z) / l11;
    double x = (metric[3] - l10 * y - l20 * z) / l00;
    pose.rotation.rotate(w.set(x, y, z), w);
  }

  /**
   * Writes the row a for which a.y is, to first order, the motion of a point along a direction, mm.
   *
   * @param pose the tool's
   * @param x the point along x in the tool frame, mm
   * @param y its y component
   * @param z its z component
   * @param normal unit direction, world
   * @param scratch overwritten
   * @param row where to write
   * @param at index of the first of six entries
   */
  public void contactRow(
      Pose pose, double x, double y, double z, Vec3 normal, Vec3 scratch, double[] row, int at) {
    Vec3 n = pose.rotation.inverseRotate(normal, scratch);
    double turnX = y * n.z - z * n.y;
    double turnY = z * n.x - x * n.z;
    double turnZ = x * n.y - y * n.x;
    row[at] = normal.x;
    row[at + 1] = normal.y;
    row[at + 2] = normal.z;
    row[at + 3] = turnX / l00;
    row[at + 4] = (turnY - l10 * row[at + 3]) / l11;
    row[at + 5] = (turnZ - l20 * row[at + 3] - l21 * row[at + 4]) / l22;
  }
}
