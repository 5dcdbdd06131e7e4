package org.palpate.benchmarks.accuracy;

import org.palpate.geometry.Vec3;
import org.palpate.volume.phantom.AnalyticSurface;

/**
 * The half-space below a plane across z.
 *
 * @param height the coordinate z of the plane
 */
record HorizontalPlane(double height) implements AnalyticSurface {
  @Override
  public double signedDistance(Vec3 at) {
    return at.z - height;
  }

  @Override
  public Vec3 normal(Vec3 at, Vec3 dest) {
    return dest.set(0, 0, 1);
  }
}
