package org.palpate.scene.surface;

import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/**
 * The source of a surface.
 *
 * @param bits the solid voxels
 * @param crossings position of the surface between two voxels
 * @param spacingMm edge lengths of a voxel
 * @param smoothing passes that smooth the steps of the voxels, each vertex within its cell, 0 to
 *     {@link SurfaceExtractor#MAX_SMOOTHING}: most for bits, few for grey values
 */
public record SurfaceSource(BitCube bits, EdgeCrossings crossings, Vec3 spacingMm, int smoothing) {
  /** Checks the smoothing. */
  public SurfaceSource {
    if (smoothing < 0 || smoothing > SurfaceExtractor.MAX_SMOOTHING) {
      throw new IllegalArgumentException(
          "smoothing must be 0 to " + SurfaceExtractor.MAX_SMOOTHING + ": smoothing=" + smoothing);
    }
  }

  /** Returns the surface of bits alone. */
  public static SurfaceSource ofBits(BitCube bits, Vec3 spacingMm) {
    return new SurfaceSource(
        bits, EdgeCrossings.MIDPOINT, spacingMm, SurfaceExtractor.MAX_SMOOTHING);
  }

  /** Returns the surface of a segment that a threshold or a range of grey values made. */
  public static SurfaceSource ofGrey(BitCube bits, GreyRange grey, Vec3 spacingMm) {
    return new SurfaceSource(bits, grey.crossings(), spacingMm, 1);
  }
}
