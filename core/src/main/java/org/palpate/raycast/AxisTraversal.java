package org.palpate.raycast;

/**
 * The traversal of a ray along one axis, from cell to cell, with the ray parameter of the next grid
 * plane that it crosses.
 *
 * <p>Invariant: each crossing is computed from its plane, never by accumulation. So its relative
 * error is at most 4 roundings, far below {@link #DOUBT_RELATIVE}.
 */
final class AxisTraversal {
  /**
   * The order of two crossings is in doubt if they differ by less than this fraction of the later
   * crossing.
   */
  static final double DOUBT_RELATIVE = 0x1p-48;

  /**
   * A bound of the error that underflow can add to a crossing, far below any relevant parameter.
   */
  static final double DOUBT_ABSOLUTE = 0x1p-1000;

  private double from;
  private double delta;
  private double inverse;

  /** The direction: 1, -1, or 0 if the ray does not move along this axis. */
  int step;

  /** The present cell. */
  int cell;

  /**
   * The ray parameter at which the ray leaves the present cell, to within {@link #doubt}; infinite
   * if it never does.
   */
  double next;

  /** Returns the largest possible error of a crossing that was computed as t. */
  static double doubt(double t) {
    return t * DOUBT_RELATIVE + DOUBT_ABSOLUTE;
  }

  /**
   * Starts before the first plane that the ray crosses at 0 or later. A ray that starts on a plane
   * starts in the cell behind it, so that the closed cells on both sides are visited.
   *
   * @param layer the cell of a ray that does not move along this axis
   */
  void begin(double newFrom, double to, int layer) {
    from = newFrom;
    delta = to - newFrom;
    if (delta == 0) {
      step = 0;
      cell = layer;
      next = Double.POSITIVE_INFINITY;
      return;
    }
    inverse = 1 / delta;
    step = delta > 0 ? 1 : -1;
    placeBefore(delta > 0 ? (int) Math.ceil(newFrom) : (int) Math.floor(newFrom));
  }

  /** Returns the parameter at which a ray that moves along this axis crosses a plane, or would. */
  double crossing(int plane) {
    return (plane - from) * inverse;
  }

  /** Whether the ray starts before the plane, in the direction of the ray. */
  boolean startsBefore(int plane) {
    return step > 0 ? from < plane : from > plane;
  }

  /** Moves to the next cell. */
  void advance() {
    cell += step;
    next = crossing(plane());
  }

  /** Returns the parameter at which the ray leaves the cube of 2^shift voxels of its cell. */
  double exit(int shift) {
    return step == 0 ? Double.POSITIVE_INFINITY : crossing(exitPlane(shift));
  }

  /**
   * Moves within the cube of 2^shift voxels to the last cell whose far plane is not surely crossed
   * before t.
   */
  void skipTo(double t, int shift) {
    if (step != 0) {
      placeBefore(firstPlaneNotBefore(t - doubt(t), plane(), exitPlane(shift)));
    }
  }

  /**
   * Moves before the first plane that is not surely crossed before t, among the planes from {@code
   * first} to {@code last} in the direction of the ray.
   */
  void skipTo(double t, int first, int last) {
    if (step != 0) {
      placeBefore(firstPlaneNotBefore(t - doubt(t), first, last));
    }
  }

  private int firstPlaneNotBefore(double t, int first, int last) {
    double position = from + t * delta; // only a guess: the crossings themselves correct it
    int guess = step > 0 ? (int) Math.ceil(position) : (int) Math.floor(position);
    int plane = Math.max(Math.min(first, last), Math.min(Math.max(first, last), guess));
    while (plane != first && crossing(plane - step) >= t) {
      plane -= step;
    }
    while (plane != last && crossing(plane) < t) {
      plane += step;
    }
    return plane;
  }

  private void placeBefore(int plane) {
    cell = step > 0 ? plane - 1 : plane;
    next = crossing(plane);
  }

  private int plane() {
    return step > 0 ? cell + 1 : cell;
  }

  private int exitPlane(int shift) {
    return ((cell >> shift) + (step > 0 ? 1 : 0)) << shift;
  }
}
