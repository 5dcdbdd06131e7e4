package org.palpate.proxy.smooth;

import org.palpate.geometry.Vec3;

/**
 * Which share of solid the surface has that the point slides on: the one found {@link
 * #HEIGHT_EDGES} above a plane of solid. The kernel is taken for a Gaussian, which it is to 0.005.
 */
final class SurfaceLevel {
  /**
   * How far the surface runs outside the plane between solid and empty voxels, in shortest edges.
   * Voxels stand out by up to 0.87, so that few legs on it are blocked.
   */
  static final double HEIGHT_EDGES = 0.97;

  private static final double DENSITY_AT_0 = 0.3989422804014327;

  private final double varianceX;
  private final double varianceY;
  private final double varianceZ;
  private final boolean alike;
  private final double share;
  private final double slope;

  /** The level for a field's smoothing. */
  SurfaceLevel(NodeSource source) {
    varianceX = source.sigmaEdges(0) * source.sigmaEdges(0);
    varianceY = source.sigmaEdges(1) * source.sigmaEdges(1);
    varianceZ = source.sigmaEdges(2) * source.sigmaEdges(2);
    alike = varianceX == varianceY && varianceX == varianceZ;
    double sigma = source.sigmaEdges(0);
    share = shareAt(HEIGHT_EDGES / sigma);
    double deviations = HEIGHT_EDGES / sigma;
    slope = DENSITY_AT_0 * StrictMath.exp(-0.5 * deviations * deviations) / sigma;
  }

  /** The share on the surface where its unit normal is {@code normal}. */
  double share(Vec3 normal) {
    if (alike) {
      return share;
    }
    double variance =
        varianceX * normal.x * normal.x
            + varianceY * normal.y * normal.y
            + varianceZ * normal.z * normal.z;
    return shareAt(HEIGHT_EDGES / Math.sqrt(variance));
  }

  /** The slope of the field on the surface of a half space along x, an edge; positive. */
  double slope() {
    return slope;
  }

  /** The share of a Gaussian beyond {@code t} standard deviations, to 1e-3 for t up to 1. */
  private static double shareAt(double t) {
    double tt = t * t;
    return 0.5 - DENSITY_AT_0 * t * (1 - tt * (1.0 / 6 - tt * (1.0 / 40 - tt / 336)));
  }
}
