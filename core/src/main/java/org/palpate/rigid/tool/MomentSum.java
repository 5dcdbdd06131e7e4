package org.palpate.rigid.tool;

import org.palpate.geometry.Vec3;

/**
 * Accumulates the mean and the covariance of equal parts of matter, such as voxels. Welford's
 * update does not cancel far from the origin. Belongs to one thread.
 */
final class MomentSum {
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

  /** Adds a part at a point, mm. */
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

  /** Returns the properties of all parts as points of mass 1. */
  MassProperties massProperties() {
    double n = Math.max(1, count);
    double[] covariance = {xx / n, yy / n, zz / n, xy / n, xz / n, yz / n};
    return new MassProperties(count, new Vec3(x, y, z), covariance);
  }
}
