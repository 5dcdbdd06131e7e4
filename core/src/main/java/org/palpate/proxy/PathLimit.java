package org.palpate.proxy;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;

/**
 * The longest path of the interaction point in one frame, w_max, and the cut of a leg to the part
 * of it that remains.
 *
 * <p>Invariant: the metric length of a leg that was cut is at most the remaining path, as {@link
 * GridMetric#distance} computes it. All verified motion is cut here and nowhere else. Immutable;
 * allocates nothing.
 */
public final class PathLimit {
  /**
   * A leg is cut shorter than the remaining path by this factor, so that rounding cannot lengthen
   * it beyond.
   */
  private static final double CUT_SHORT = 1 - 0x1p-40;

  /** A square that is smaller by this factor is smaller whatever the rounding. */
  private static final double SURELY_LESS = 1 - 0x1p-40;

  private final GridMetric metric;
  private final double maxPathMm;

  /**
   * Creates a limit.
   *
   * @param metric the spacing of the grid
   * @param maxPathMm the longest path of one frame, w_max, positive; may be infinite
   * @throws IllegalArgumentException if {@code maxPathMm} is not positive
   */
  public PathLimit(GridMetric metric, double maxPathMm) {
    if (!(maxPathMm > 0)) {
      throw new IllegalArgumentException("maxPathMm must be positive: maxPathMm=" + maxPathMm);
    }
    this.metric = metric;
    this.maxPathMm = maxPathMm;
  }

  /**
   * {@return the path that remains after the legs of this frame, mm}
   *
   * @param legs the legs of this frame so far
   */
  public double remainingMm(LegPath legs) {
    return maxPathMm - legs.lengthMm();
  }

  /**
   * {@return whether a further leg would make the path of this frame too long}
   *
   * @param legs the legs of this frame so far
   * @param lengthMm the length of the further leg, mm
   */
  public boolean isExceededBy(LegPath legs, double lengthMm) {
    return legs.lengthMm() + lengthMm > maxPathMm;
  }

  /**
   * {@return whether so little path remains that no leg can make use of it}
   *
   * @param legs the legs of this frame so far
   */
  public boolean isUsedUp(LegPath legs) {
    return legs.lengthMm() >= maxPathMm * CUT_SHORT;
  }

  /**
   * Cuts the leg between two points to the remaining path.
   *
   * @param legs the legs of this frame so far
   * @param from the start of the leg, grid coordinates, finite
   * @param to its end, grid coordinates, finite
   * @param dest receives the end of the leg after the cut, which may be {@code from} itself; may be
   *     {@code to}
   * @return whether the leg was cut; if not, {@code dest} equals {@code to}
   */
  public boolean cut(LegPath legs, Vec3 from, Vec3 to, Vec3 dest) {
    double leftMm = remainingMm(legs);
    double square = metric.squaredDistance(from.x, from.y, from.z, to.x, to.y, to.z);
    if (leftMm > 0 && square < leftMm * leftMm * SURELY_LESS) {
      dest.set(to); // nearly always, and without a square root
      return false;
    }
    double lengthMm = Math.sqrt(square);
    if (lengthMm <= leftMm) {
      dest.set(to);
      return false;
    }
    cut(leftMm, lengthMm, from, to, dest);
    return true;
  }

  private void cut(double leftMm, double lengthMm, Vec3 from, Vec3 to, Vec3 dest) {
    double fraction = Math.max(0, leftMm / lengthMm * CUT_SHORT);
    dest.set(
        from.x + fraction * (to.x - from.x),
        from.y + fraction * (to.y - from.y),
        from.z + fraction * (to.z - from.z));
    if (metric.distance(from.x, from.y, from.z, dest.x, dest.y, dest.z) > leftMm) {
      dest.set(from); // so far out that two doubles lie farther apart than the remaining path
    }
  }
}
