package org.palpate.raycast;

/**
 * The walk of a ray along one axis, from cell to cell, with the ray parameter of the next plane
 * that it crosses.
 *
 * <p>A crossing is computed anew from the plane, never by adding up, so its relative error is at
 * most 4 roundings wherever the walk is: {@link #DOUBT_RELATIVE} is far above it.
 */
final class AxisTraversal {
  /**
   * Two crossings that differ by less than this share of the later one may be in either order, or
   * one.
   */
  static final double DOUBT_RELATIVE = 0x1p-48;

  /**
   * What underflow can add to the error of a crossing, and far less than any parameter that
   * matters.
   */
  static final double DOUBT_ABSOLUTE = 0x1p-1000;

  private double from;
  private double delta;
  private double inverse;

  /** 1, -1, or 0 where the ray does not move along this axis. */
  int step;

  /** The cell where the walk is. */
  int cell;

  /**
   * The ray parameter where it leaves the cell, to within {@link #doubt}; infinite where it never
   * does.
   */
  double next;

  /** How far a computed crossing at t may lie from the true one. */
  static double doubt(double t) {
    return t * DOUBT_RELATIVE + DOUBT_ABSOLUTE;
  }

  /**
   * Sets the walk before the first plane that is crossed at 0 or later. A ray that starts on a
   * plane starts in the cell behind it, so that the closed cells on both sides are visited.
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

  /** Where the ray, which moves along this axis, crosses a plane; may be negative. */
  double crossing(int plane) {
    return (plane - from) * inverse;
  }

  /** Whether the ray starts before the plane, seen along its direction. */
  boolean startsBefore(int plane) {
    return step > 0 ? from < plane : from > plane;
  }

  /** Goes on to the next cell. */
  void advance() {
    cell += step;
    next = crossing(plane());
  }

  /** Where the walk leaves the cube of 2^shift voxels that its cell lies in. */
  double exit(int shift) {
    return step == 0 ? Double.POSITIVE_INFINITY : crossing(exitPlane(shift));
  }

  /**
   * Goes on, inside the cube of 2^shift voxels, to the last cell whose far plane is not crossed
   * surely before t.
   */
  void skipTo(double t, int shift) {
    if (step != 0) {
      placeBefore(firstPlaneNotBefore(t - doubt(t), plane(), exitPlane(shift)));
    }
  }

  /**
   * Sets the walk before the first plane, from {@code first} to {@code last} in its direction, not
   * crossed surely before t.
   */
  void skipTo(double t, int first, int last) {
    if (step != 0) {
      placeBefore(firstPlaneNotBefore(t - doubt(t), first, last));
    }
  }

  private int firstPlaneNotBefore(double t, int first, int last) {
    double position = from + t * delta; // only a guess: it is mended by the crossings themselves
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
