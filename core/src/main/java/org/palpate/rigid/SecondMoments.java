package org.palpate.rigid;

/**
 * Mean and covariance of the matter of a tool, summed over equal parts. The covariance about the
 * mean is what a solid of uniform density needs for its kinetic energy. Mutable until read.
 */
final class SecondMoments {
  private long count;
  private double x;
  private double y;
  private double z;
  private double xx;
  private double yy;
  private double zz;
  private double xy;
  private double xz;
  private double yz;

  /** Adds a part at a point, mm, by Welford's update, which does not cancel far from 0. */
  void add(double px, double py, double pz) {
    count++;
    double dx = px - x;
    double dy = py - y;
    double dz = pz - z;
    x += dx / count;
    y += dy / count;
    z += dz / count;
    xx += dx * (px - x);
    yy += dy * (py - y);
    zz += dz * (pz - z);
    xy += dx * (py - y);
    xz += dx * (pz - z);
    yz += dy * (pz - z);
  }

  long count() {
    return count;
  }

  double meanX() {
    return x;
  }

  double meanY() {
    return y;
  }

  double meanZ() {
    return z;
  }

  /** Returns the covariance about the mean: xx, yy, zz, xy, xz, yz, mm^2. */
  double[] covariance() {
    double n = Math.max(1, count);
    return new double[] {xx / n, yy / n, zz / n, xy / n, xz / n, yz / n};
  }
}
