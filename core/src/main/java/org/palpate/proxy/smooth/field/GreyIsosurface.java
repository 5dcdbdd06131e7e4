package org.palpate.proxy.smooth.field;

import org.palpate.volume.ScalarVolume;

/**
 * The grey values that a segment was made of by a threshold: what lies between its voxels.
 *
 * @param volume over the same grid as the segment's bits; read by the haptic thread, not changed
 * @param threshold the least value of a voxel of the segment
 * @param contrast how far beyond the threshold a voxel counts as wholly solid, and how far below it
 *     as wholly empty; positive
 */
public record GreyIsosurface(ScalarVolume volume, double threshold, double contrast) {

  /** Checks the contrast. */
  public GreyIsosurface {
    if (!(contrast > 0) || Double.isInfinite(contrast)) {
      throw new IllegalArgumentException(
          "contrast must be positive and finite: contrast=" + contrast);
    }
  }

  /**
   * By how much of the whole step two neighbours along an axis differ on average, of which one is
   * in the segment and one is not, where the edge is sharp: over all directions of a ball's
   * surface.
   */
  private static final double PAIR_SHARE_OF_STEP = 0.61;

  /**
   * With the contrast that the values have at the surface: half the step from one side of it to the
   * other, told by neighbours that the threshold parts. One pass over the values.
   */
  public static GreyIsosurface ofThreshold(ScalarVolume volume, double threshold) {
    EdgeContrast tally = new EdgeContrast(volume, threshold);
    double step = tally.meanDifference() / PAIR_SHARE_OF_STEP;
    return new GreyIsosurface(
        volume, threshold, step > 0 && step < Double.MAX_VALUE ? step / 2 : 1);
  }

  /** The share of a voxel of this value that is solid, 0 to 1. */
  double share(double value) {
    double share = 0.5 + 0.5 * (value - threshold) / contrast;
    return Math.max(0, Math.min(1, share));
  }
}
