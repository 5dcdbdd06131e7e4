package org.palpate.benchmarks.accuracy;

import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.AnalyticSurface;

/** Makes bits that sample an analytic surface with voxels of any size. */
public final class SampledSolids {
  private SampledSolids() {}

  /**
   * Returns the voxels whose centres are inside. The grid begins at the origin of the surface.
   *
   * @param truth the surface, mm
   * @param edgeMm the edge of the cube that the voxels fill
   */
  public static BitCube of(AnalyticSurface truth, double edgeMm, Vec3 spacingMm) {
    BitCube bits =
        new BitCube(
            (int) (edgeMm / spacingMm.x),
            (int) (edgeMm / spacingMm.y),
            (int) (edgeMm / spacingMm.z));
    Vec3 centre = new Vec3();
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          centre.set((i + 0.5) * spacingMm.x, (j + 0.5) * spacingMm.y, (k + 0.5) * spacingMm.z);
          if (truth.signedDistance(centre) < 0) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }
}
