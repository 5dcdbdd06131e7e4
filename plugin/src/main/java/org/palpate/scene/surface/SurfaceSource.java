package org.palpate.scene.surface;

import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/**
 * What a surface is made from.
 *
 * @param bits the solid voxels
 * @param crossings where between two voxels the surface runs
 * @param spacingMm edge lengths of a voxel
 * @param smoothing how far the stairs of voxels are smoothed, each vertex within its cell: most for
 *     bits alone, little for grey values; 0 to {@link SurfaceExtractor#MAX_SMOOTHING}
 */
public record SurfaceSource(BitCube bits, EdgeCrossings crossings, Vec3 spacingMm, int smoothing) {
  /** Checks the smoothing. */
  public SurfaceSource {
    if (smoothing < 0 || smoothing > SurfaceExtractor.MAX_SMOOTHING) {
      throw new IllegalArgumentException(
          "smoothing must be 0 to " + SurfaceExtractor.MAX_SMOOTHING + ": smoothing=" + smoothing);
    }
  }

  /** The surface of bits alone. */
  public static SurfaceSource ofBits(BitCube bits, Vec3 spacingMm) {
    return new SurfaceSource(
        bits, EdgeCrossings.MIDPOINT, spacingMm, SurfaceExtractor.MAX_SMOOTHING);
  }

  /** The surface of a segment that came from grey values by a threshold. */
  public static SurfaceSource ofGrey(
      BitCube bits, GreyEdgeCrossings.Values values, float threshold, Vec3 spacingMm) {
    return new SurfaceSource(bits, new GreyEdgeCrossings(values, threshold), spacingMm, 1);
  }

  /** The surface of a segment that came from grey values by a threshold or a range. */
  public static SurfaceSource ofGrey(BitCube bits, GreyRange grey, Vec3 spacingMm) {
    return new SurfaceSource(bits, grey.crossings(), spacingMm, 1);
  }
}
