package org.palpate.accuracy;

import org.palpate.geometry.Vec3;
import org.palpate.volume.phantom.AnalyticSurface;

/**
 * The inner side of a wall of some thickness below the surface of a solid.
 *
 * @param solid the solid
 * @param wallMm the thickness, mm
 */
record CavitySurface(AnalyticSurface solid, double wallMm) implements AnalyticSurface {
  @Override
  public double signedDistance(Vec3 point) {
    return -solid.signedDistance(point) - wallMm;
  }

  @Override
  public Vec3 normal(Vec3 point, Vec3 dest) {
    return solid.normal(point, dest).mul(-1, dest);
  }
}
