package org.palpate.scene.surface;

/**
 * Crossings by linear interpolation of grey values, for a segment that came from a threshold or a
 * range. Where the values contradict the bits (an edited voxel), half way.
 */
public final class GreyEdgeCrossings implements EdgeCrossings {

  /** Grey values of a grid. Read by several threads at once. */
  @FunctionalInterface
  public interface Values {
    /** The value of a voxel; NaN outside the grid. */
    float at(int i, int j, int k);
  }

  // Keeps a vertex off the voxel centres, where sheets of thin walls would meet.
  private static final float MARGIN = 0.02f;

  private final Values values;
  private final float low;
  private final float high;

  /**
   * Crossings where the values pass the threshold.
   *
   * @param threshold between the values of solid and those of empty voxels
   */
  public GreyEdgeCrossings(Values values, float threshold) {
    this(values, threshold, Float.POSITIVE_INFINITY);
  }

  /**
   * Crossings where the values enter or leave a range.
   *
   * @param low between the values of solid voxels and lower ones of empty voxels
   * @param high between the values of solid voxels and higher ones of empty voxels
   */
  public GreyEdgeCrossings(Values values, float low, float high) {
    this.values = values;
    this.low = low;
    this.high = high;
  }

  @Override
  public float fraction(int i, int j, int k, int axis) {
    float from = values.at(i, j, k);
    float to = values.at(i + (axis == 0 ? 1 : 0), j + (axis == 1 ? 1 : 0), k + (axis == 2 ? 1 : 0));
    float threshold = Math.min(from, to) < low ? low : high;
    float fraction = (threshold - from) / (to - from);
    // NaN and infinity, outside the grid or on equal values, fail the comparison.
    return fraction >= 0 && fraction <= 1 ? Math.max(MARGIN, Math.min(1 - MARGIN, fraction)) : 0.5f;
  }
}
