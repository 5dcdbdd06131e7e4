package org.palpate.proxy.smooth.field;

import org.palpate.volume.GreyQuantizer;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/**
 * The grey values from which a segment was made by a threshold. They show where the surface runs
 * between its voxels. Immutable; a frame that takes one over allocates nothing.
 */
public final class GreyIsosurface {

  /**
   * The mean difference between neighbours on different sides of a sharp edge, as a fraction of the
   * whole step. It is the mean over all directions of a ball's surface.
   */
  private static final double PAIR_FRACTION_OF_STEP = 0.61;

  /** The contrast where the values show none. */
  private static final double DEFAULT_CONTRAST = 1;

  private final ScalarVolume volume;
  private final double threshold;
  private final double contrast;
  private final GreyQuantizer quantizer;

  /**
   * Creates an isosurface. Cost: a table of the levels of all integers of two bytes.
   *
   * @param volume the grey values over the grid of the segment's bits; the haptic thread reads them
   *     and nobody changes them
   * @param threshold the least value of a voxel in the segment
   * @param contrast how far above the threshold a voxel is fully solid, and how far below it fully
   *     empty; positive and finite
   * @throws IllegalArgumentException if the contrast is not positive and finite
   */
  public GreyIsosurface(ScalarVolume volume, double threshold, double contrast) {
    if (!(contrast > 0) || Double.isInfinite(contrast)) {
      throw new IllegalArgumentException(
          "contrast must be positive and finite: contrast=" + contrast);
    }
    this.volume = volume;
    this.threshold = threshold;
    this.contrast = contrast;
    quantizer = new GreyQuantizer(threshold, 0.5 * GreyOccupancyCache.WHOLE / contrast);
  }

  /**
   * {@return the isosurface of a threshold} Its contrast is measured: half the mean step of the
   * values from one side of the surface to the other. Cost: one pass over the values.
   *
   * @param volume the grey values; kept
   * @param threshold the value at the surface, in the unit of the volume
   */
  public static GreyIsosurface ofThreshold(ScalarVolume volume, double threshold) {
    double step = new EdgeContrast(volume, threshold).meanDifference() / PAIR_FRACTION_OF_STEP;
    boolean usable = step > 0 && step < Double.MAX_VALUE;
    return new GreyIsosurface(volume, threshold, usable ? step / 2 : DEFAULT_CONTRAST);
  }

  /** {@return the grey values over the grid of the segment's bits} */
  public ScalarVolume volume() {
    return volume;
  }

  /** {@return the least value of a voxel in the segment} */
  public double threshold() {
    return threshold;
  }

  /**
   * {@return how far above the threshold a voxel is fully solid, and how far below it fully empty}
   */
  public double contrast() {
    return contrast;
  }

  /** Returns the occupancies that grey values stand for, as levels. */
  GreyQuantizer quantizer() {
    return quantizer;
  }

  /**
   * Measures the contrast of edges: the mean difference between neighbouring grey values on
   * different sides of a threshold.
   */
  private static final class EdgeContrast {
    private final ScalarVolume volume;
    private final double threshold;
    private double sum;
    private long pairs;

    EdgeContrast(ScalarVolume volume, double threshold) {
      this.volume = volume;
      this.threshold = threshold;
    }

    /**
     * Returns the mean difference over all pairs of neighbours across the threshold; 0 without one.
     */
    double meanDifference() {
      VoxelGrid grid = volume.grid();
      for (int k = 0; k < grid.sizeZ(); k++) {
        for (int j = 0; j < grid.sizeY(); j++) {
          for (int i = 0; i < grid.sizeX(); i++) {
            double value = volume.value(i, j, k);
            if (i > 0) {
              addPair(value, volume.value(i - 1, j, k));
            }
            if (j > 0) {
              addPair(value, volume.value(i, j - 1, k));
            }
            if (k > 0) {
              addPair(value, volume.value(i, j, k - 1));
            }
          }
        }
      }
      return pairs == 0 ? 0 : sum / pairs;
    }

    /** Adds a pair if the threshold lies between its values. */
    private void addPair(double value, double neighbour) {
      if (value >= threshold != neighbour >= threshold && Double.isFinite(value - neighbour)) {
        sum += Math.abs(value - neighbour);
        pairs++;
      }
    }
  }
}
