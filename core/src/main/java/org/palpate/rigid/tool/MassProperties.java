package org.palpate.rigid.tool;

import org.palpate.geometry.Vec3;

/** Volume, centroid and second moments of matter of uniform density. Immutable; any thread. */
public final class MassProperties {
  private final double volumeMm3;
  private final Vec3 centroidMm;
  private final double[] covariance;

  /**
   * Creates mass properties.
   *
   * @param volumeMm3 the volume, mm^3; for matter without volume, its area or number of parts
   * @param centroidMm the centroid, mm
   * @param covariance the covariance about the centroid: xx, yy, zz, xy, xz, yz, mm^2
   */
  MassProperties(double volumeMm3, Vec3 centroidMm, double... covariance) {
    this.volumeMm3 = volumeMm3;
    this.centroidMm = centroidMm;
    this.covariance = covariance;
  }

  /** {@return the volume, mm^3; for matter without volume, its area or number of parts} */
  public double volumeMm3() {
    return volumeMm3;
  }

  /** {@return the centroid, mm; not to be written} */
  public Vec3 centroidMm() {
    return centroidMm;
  }

  /** Returns the metric of the matter, with the centroid as reference point. */
  KineticMetric metric() {
    return new KineticMetric(covariance);
  }

  /** Returns the properties of two parts together. */
  static MassProperties sum(MassProperties a, MassProperties b) {
    double volume = a.volumeMm3 + b.volumeMm3;
    double partA = a.volumeMm3 / volume;
    double partB = b.volumeMm3 / volume;
    Vec3 d = b.centroidMm.sub(a.centroidMm, new Vec3());
    double[] offset = {d.x * d.x, d.y * d.y, d.z * d.z, d.x * d.y, d.x * d.z, d.y * d.z};
    double[] covariance = new double[6];
    for (int n = 0; n < covariance.length; n++) {
      covariance[n] = partA * a.covariance[n] + partB * b.covariance[n] + partA * partB * offset[n];
    }
    Vec3 centroid = d.mul(partB, new Vec3()).add(a.centroidMm, new Vec3());
    return new MassProperties(volume, centroid, covariance);
  }
}
