package org.palpate.benchmarks.rigid;

import org.palpate.geometry.Vec3;
import org.palpate.volume.phantom.AnalyticSurface;

/**
 * The surface at a height above another one, on which the centre of a ball rolls.
 *
 * @param surface the surface below
 * @param heightMm the height, mm
 */
record OffsetSurface(AnalyticSurface surface, double heightMm) implements AnalyticSurface {
  @Override
  public double signedDistance(Vec3 point) {
    return surface.signedDistance(point) - heightMm;
  }

  @Override
  public Vec3 normal(Vec3 point, Vec3 dest) {
    return surface.normal(point, dest);
  }
}
