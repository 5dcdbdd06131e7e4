package org.palpate.scene.surface;

/**
 * Crossings by linear interpolation of grey values, for a segment by a threshold or a range. If the
 * values contradict the bits, as after an edit, the crossing is at the midpoint.
 */
final class GreyEdgeCrossings implements EdgeCrossings {

  /** Grey values of a grid. Several threads read them at once. */
  @FunctionalInterface
  interface Values {
    /** Returns the value of a voxel; NaN outside the grid. */
    float at(int i, int j, int k);
  }

  // Keeps vertices away from the voxel centres, where the two sides of a thin wall would meet.
  private static final float MARGIN = 0.02f;

  private final Values values;
  private final float low;
  private final float high;

  /**
   * Creates crossings where the values enter or leave a range.
   *
   * @param low value between those of solid voxels and lower ones of empty voxels
   * @param high value between those of solid voxels and higher ones of empty voxels; infinite for a
   *     threshold
   */
  GreyEdgeCrossings(Values values, float low, float high) {
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
    // NaN and infinity, from outside the grid or equal values, fail the comparison.
    return fraction >= 0 && fraction <= 1 ? Math.max(MARGIN, Math.min(1 - MARGIN, fraction)) : 0.5f;
  }
}
