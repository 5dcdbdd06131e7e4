package org.palpate.accuracy;

import org.palpate.geometry.Vec3;
import org.palpate.volume.phantom.AnalyticSurface;

/**
 * A wall of some thickness below the surface of a solid; the normal is that of the solid.
 *
 * @param solid the solid
 * @param wallMm the thickness, mm
 */
record WallSurface(AnalyticSurface solid, double wallMm) implements AnalyticSurface {
  @Override
  public double signedDistance(Vec3 point) {
    double height = solid.signedDistance(point);
    return Math.max(height, -height - wallMm);
  }

  @Override
  public Vec3 normal(Vec3 point, Vec3 dest) {
    return solid.normal(point, dest);
  }
}
