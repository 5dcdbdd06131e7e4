package org.palpate.benchmarks.accuracy;

import org.palpate.geometry.Vec3;
import org.palpate.volume.phantom.AnalyticSurface;

/**
 * Counts the samples of a voxel that lie inside a surface. The samples are halved again and again:
 * where all of a part lie nearer to its middle than the surface does, one distance decides them.
 */
final class SampledVoxel {
  /**
   * Covers the rounding of a distance: samples this near to the surface are looked at singly, mm.
   */
  private static final double MARGIN_MM = 1e-6;

  private final AnalyticSurface truth;
  private final Vec3 spacingMm;
  private final int countX;
  private final int countY;
  private final int countZ;
  private final Vec3 corner = new Vec3();
  private final Vec3 at = new Vec3();

  SampledVoxel(AnalyticSurface truth, Vec3 spacingMm, int samplesPerMm) {
    this.truth = truth;
    this.spacingMm = spacingMm;
    countX = (int) Math.ceil(samplesPerMm * spacingMm.x);
    countY = (int) Math.ceil(samplesPerMm * spacingMm.y);
    countZ = (int) Math.ceil(samplesPerMm * spacingMm.z);
  }

  /** Returns the solid fraction of the voxel whose lowest corner is given, mm. */
  double solidFraction(Vec3 cornerMm) {
    corner.set(cornerMm);
    return solid(0, 0, 0, countX, countY, countZ) / (double) (countX * countY * countZ);
  }

  /** Returns how many samples are solid of a block that begins at sample x, y, z. */
  private int solid(int x, int y, int z, int sizeX, int sizeY, int sizeZ) {
    at.set(
        corner.x + (x + sizeX / 2.0) / countX * spacingMm.x,
        corner.y + (y + sizeY / 2.0) / countY * spacingMm.y,
        corner.z + (z + sizeZ / 2.0) / countZ * spacingMm.z);
    double height = truth.signedDistance(at);
    int samples = sizeX * sizeY * sizeZ;
    if (samples == 1 || Math.abs(height) > reach(sizeX, sizeY, sizeZ)) {
      return height < 0 ? samples : 0;
    }
    if (sizeX >= Math.max(sizeY, sizeZ)) {
      int half = sizeX / 2;
      return solid(x, y, z, half, sizeY, sizeZ) + solid(x + half, y, z, sizeX - half, sizeY, sizeZ);
    }
    if (sizeY >= sizeZ) {
      int half = sizeY / 2;
      return solid(x, y, z, sizeX, half, sizeZ) + solid(x, y + half, z, sizeX, sizeY - half, sizeZ);
    }
    int half = sizeZ / 2;
    return solid(x, y, z, sizeX, sizeY, half) + solid(x, y, z + half, sizeX, sizeY, sizeZ - half);
  }

  /** Returns how far the outermost samples of a block are from its middle, mm. */
  private double reach(int sizeX, int sizeY, int sizeZ) {
    double x = (sizeX - 1.0) / countX * spacingMm.x;
    double y = (sizeY - 1.0) / countY * spacingMm.y;
    double z = (sizeZ - 1.0) / countZ * spacingMm.z;
    return Math.sqrt(x * x + y * y + z * z) / 2 + MARGIN_MM;
  }
}
