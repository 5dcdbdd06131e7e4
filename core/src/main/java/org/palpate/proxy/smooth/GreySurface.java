package org.palpate.proxy.smooth;

import org.palpate.volume.ScalarVolume;

/**
 * The grey values that a segment was made of by a threshold: what lies between its voxels.
 *
 * @param volume over the same grid as the segment's bits; read by the haptic thread, not changed
 * @param threshold the least value of a voxel of the segment
 * @param contrast how far beyond the threshold a voxel counts as wholly solid, and how far below it
 *     as wholly empty; positive
 */
public record GreySurface(ScalarVolume volume, double threshold, double contrast) {

  /** Checks the contrast. */
  public GreySurface {
    if (!(contrast > 0) || Double.isInfinite(contrast)) {
      throw new IllegalArgumentException(
          "contrast must be positive and finite: contrast=" + contrast);
    }
  }

  /** The share of a voxel of this value that is solid, 0 to 1. */
  double share(double value) {
    double share = 0.5 + 0.5 * (value - threshold) / contrast;
    return Math.max(0, Math.min(1, share));
  }
}
