package org.palpate.rigid.skip;

import java.util.Arrays;

/**
 * The path that the points of a tool have gone against a body. For each point, and for each leaf of
 * the tool's tree, it keeps the path up to which the points are known to be free. The path is the
 * sum, over committed motions, of the longest motion of any point along an axis, cells. Haptic
 * thread only.
 */
public final class Odometer {
  /** The path is reset here, before its own rounding could matter. */
  private static final double LONGEST = 1 << 20;

  private double path;
  private final double[] pointFreeUntil;
  private final double[] leafFreeUntil;

  /**
   * Creates an odometer of points and leaves that are not known to be free.
   *
   * @param points the number of points
   * @param leaves the number of leaves
   */
  public Odometer(int points, int leaves) {
    pointFreeUntil = new double[points];
    leafFreeUntil = new double[leaves];
    reset();
  }

  /** Forgets what is known to be free. */
  public void reset() {
    path = 0;
    Arrays.fill(pointFreeUntil, -1);
    Arrays.fill(leafFreeUntil, -1);
  }

  /**
   * Adds a motion.
   *
   * @param travel the longest motion of any point along an axis, cells
   */
  public void add(double travel) {
    path += travel;
    if (path > LONGEST) {
      reset();
    }
  }

  /**
   * {@return whether a point is free during a motion}
   *
   * @param point the index of the point
   * @param travel the longest motion of any point along an axis, cells
   */
  public boolean isPointFree(int point, double travel) {
    return path + travel <= pointFreeUntil[point];
  }

  /**
   * {@return whether all points of a leaf are free during a motion}
   *
   * @param leaf the number of the leaf
   * @param travel the longest motion of any point along an axis, cells
   */
  public boolean isLeafFree(int leaf, double travel) {
    return path + travel <= leafFreeUntil[leaf];
  }

  /**
   * Takes note that a point is free during motions of a length from here.
   *
   * @param point the index of the point
   * @param travel the length, cells; negative if it is not known to be free
   */
  public void setPointFree(int point, double travel) {
    pointFreeUntil[point] = path + travel;
  }

  /**
   * Takes note that all points of a leaf are free during motions of a length from here.
   *
   * @param leaf the number of the leaf
   * @param travel the length, cells
   */
  public void setLeafFree(int leaf, double travel) {
    leafFreeUntil[leaf] = path + travel;
  }

  /**
   * Takes note that a leaf is free as long as each of its points.
   *
   * @param leaf the number of the leaf
   * @param first the index of its first point
   * @param end the index after its last point
   */
  public void setLeafFreeByPoints(int leaf, int first, int end) {
    double until = Double.POSITIVE_INFINITY;
    for (int n = first; n < end; n++) {
      until = Math.min(until, pointFreeUntil[n]);
    }
    leafFreeUntil[leaf] = until;
  }

  /**
   * Forgets that a point is free.
   *
   * @param point the index of the point
   */
  public void forgetPoint(int point) {
    pointFreeUntil[point] = -1;
  }

  /**
   * Forgets that a leaf is free.
   *
   * @param leaf the number of the leaf
   */
  public void forgetLeaf(int leaf) {
    leafFreeUntil[leaf] = -1;
  }
}
