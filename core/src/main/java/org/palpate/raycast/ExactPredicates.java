package org.palpate.raycast;

/**
 * Decides whether a ray, as the exact segment between its two ends, touches a closed box of voxels.
 * A floating-point filter answers nearly always; if its error bound leaves a doubt, {@link
 * ExactProductSum} answers. There is no tolerance.
 *
 * <p>An instance keeps scratch memory and belongs to one thread.
 */
public final class ExactPredicates {
  /**
   * Relative error bound of a difference of two products of differences of doubles: (3 + 16 u) u
   * with u = 2^-53, rounded up. Reference: J. Shewchuk, Adaptive precision floating-point
   * arithmetic, 1997, section 4.2.
   */
  private static final double RELATIVE_ERROR = 4 * 0x1p-53;

  /** A bound of the absolute error that underflow of the two products can add. */
  private static final double UNDERFLOW_ERROR = 0x1p-1070;

  private final ExactProductSum sum = new ExactProductSum();

  /**
   * {@return whether the ray touches a closed voxel} Exact for any six finite doubles.
   *
   * @param ray the segment, in grid coordinates
   * @param i the voxel's number along x
   * @param j its number along y
   * @param k its number along z
   */
  public boolean touchesVoxel(Ray ray, int i, int j, int k) {
    return touchesBox(ray, i, j, k, 1);
  }

  /**
   * Whether the ray touches the closed cube of {@code edge} voxels whose lowest corner is (i,j,k).
   *
   * <p>A segment and a box are disjoint exactly if one of six directions separates them: the three
   * axes, and the three cross products of an axis with the segment. The latter are lines in the
   * three coordinate planes.
   */
  boolean touchesBox(Ray r, int i, int j, int k, int edge) {
    return overlaps(r.fromX, r.toX, i, edge)
        && overlaps(r.fromY, r.toY, j, edge)
        && overlaps(r.fromZ, r.toZ, k, edge)
        && lineMeetsSquare(r.fromX, r.fromY, r.toX, r.toY, i, j, edge)
        && lineMeetsSquare(r.fromY, r.fromZ, r.toY, r.toZ, j, k, edge)
        && lineMeetsSquare(r.fromZ, r.fromX, r.toZ, r.toX, k, i, edge);
  }

  private static boolean overlaps(double from, double to, int low, int edge) {
    return Math.max(from, to) >= low && Math.min(from, to) <= (double) low + edge;
  }

  /**
   * Whether the line through two points of a plane meets a closed square: not all corners lie
   * strictly on one side.
   */
  private boolean lineMeetsSquare(
      double ax, double ay, double bx, double by, int lowX, int lowY, int edge) {
    double highX = (double) lowX + edge;
    double highY = (double) lowY + edge;
    int side = side(ax, ay, bx, by, lowX, lowY);
    return side == 0
        || side != side(ax, ay, bx, by, highX, lowY)
        || side != side(ax, ay, bx, by, lowX, highY)
        || side != side(ax, ay, bx, by, highX, highY);
  }

  /**
   * Returns the sign of (c - a) x (b - a): the side of the line from a to b on which c lies. Exact.
   */
  int side(double ax, double ay, double bx, double by, double cx, double cy) {
    double left = (cx - ax) * (by - ay);
    double right = (cy - ay) * (bx - ax);
    double difference = left - right;
    double bound = RELATIVE_ERROR * (Math.abs(left) + Math.abs(right)) + UNDERFLOW_ERROR;
    if (difference > bound) {
      return 1;
    }
    if (difference < -bound) {
      return -1;
    }
    return exactSide(ax, ay, bx, by, cx, cy);
  }

  // Multiplied out: cx by - cx ay - ax by - cy bx + cy ax + ay bx; the two products ax ay cancel.
  private int exactSide(double ax, double ay, double bx, double by, double cx, double cy) {
    sum.add(cx, by);
    sum.subtract(cx, ay);
    sum.subtract(ax, by);
    sum.subtract(cy, bx);
    sum.add(cy, ax);
    sum.add(ay, bx);
    return sum.sign();
  }
}
