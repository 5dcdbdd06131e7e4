package org.palpate.volume;

/**
 * The solid fraction that a tilted plane leaves of the layers of a voxel across an axis. It falls
 * linearly from 1 to 0: the solid lies on the lower side. Lengths are in voxels.
 */
public final class LayerRamp {
  /** The least width, along the axis; a narrower ramp would be a step all the same. */
  public static final double MIN_WIDTH = 1e-3;

  /** The greatest width; a wider ramp would be even within a voxel all the same. */
  public static final double MAX_WIDTH = 64;

  private LayerRamp() {}

  /**
   * {@return the width of the ramp that a plane leaves of a voxel}
   *
   * @param along the part of the plane's gradient along the axis
   * @param squaredLength the square of the gradient's length
   */
  public static double width(double along, double squaredLength) {
    if (along == 0) {
      return MAX_WIDTH;
    }
    double across = Math.sqrt(squaredLength - along * along);
    return Math.max(MIN_WIDTH, Math.min(MAX_WIDTH, across / Math.abs(along)));
  }

  /**
   * {@return the middle of the ramp that leaves a fraction of a voxel solid} The voxel reaches from
   * 0 to 1; the middle may lie outside.
   *
   * @param fraction from 0 to 1
   * @param width the width of the ramp
   */
  public static double middle(double fraction, double width) {
    double lesser = Math.min(fraction, 1 - fraction);
    double middle;
    if (lesser < Math.min(width, 1 / width) / 2) {
      middle = Math.sqrt(2 * width * lesser) - width / 2; // only an end of the ramp is inside
    } else if (width < 1) {
      middle = lesser;
    } else {
      middle = 0.5 + (lesser - 0.5) * width;
    }
    return fraction <= 0.5 ? middle : 1 - middle;
  }

  /**
   * {@return the length of the solid between two positions}
   *
   * @param from the lower position
   * @param to the upper position
   * @param middle the middle of the ramp
   * @param width the width of the ramp
   */
  public static double solid(double from, double to, double middle, double width) {
    double start = middle - width / 2;
    return solidUpTo(to, start, width) - solidUpTo(from, start, width);
  }

  /** Returns the length of the solid below a position, but for a constant. */
  private static double solidUpTo(double position, double start, double width) {
    double beyond = position - start;
    if (beyond <= 0) {
      return position;
    }
    return beyond >= width ? start + width / 2 : position - beyond * beyond / (2 * width);
  }
}
