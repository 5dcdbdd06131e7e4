package org.palpate.elastic;

import java.util.Arrays;

/**
 * Changes of the force for which a field is proved to fold nothing: a union of double cones around
 * one axis. A cone around place t of the axis holds a change if its distance from t along the axis
 * over {@code along}, plus its distance from the axis over {@code across}, is at most 1.
 */
final class ForceRoom {
  /** The most cones. */
  static final int MOST = 24;

  private final double[] axis = {0, 0, -1};
  private final double[] place = new double[MOST];
  private final double[] along = new double[MOST];
  private final double[] across = new double[MOST];
  private int count;

  /** Removes all cones and sets the axis, a unit vector. */
  void begin(double x, double y, double z) {
    axis[0] = x;
    axis[1] = y;
    axis[2] = z;
    count = 0;
  }

  /** Copies another room. */
  void set(ForceRoom other) {
    System.arraycopy(other.axis, 0, axis, 0, axis.length);
    System.arraycopy(other.place, 0, place, 0, MOST);
    System.arraycopy(other.along, 0, along, 0, MOST);
    System.arraycopy(other.across, 0, across, 0, MOST);
    count = other.count;
  }

  /** Returns the axis. */
  double[] axis() {
    return axis;
  }

  /** Adds a cone of positive size. */
  void add(double placeNewton, double alongNewton, double acrossNewton) {
    place[count] = placeNewton;
    along[count] = alongNewton;
    across[count] = acrossNewton;
    count++;
  }

  /** Whether there is no room for another cone. */
  boolean isFull() {
    return count == MOST;
  }

  /**
   * Moves a change of the force into the room, towards the place of the cone that loses the least.
   * Without a cone, or if the length of the change is not finite, no change remains.
   *
   * @param change in place, N
   * @return whether it was moved
   */
  boolean clip(double[] change) {
    double t = change[0] * axis[0] + change[1] * axis[1] + change[2] * axis[2];
    double x = change[0] - t * axis[0];
    double y = change[1] - t * axis[1];
    double z = change[2] - t * axis[2];
    double aside = Math.sqrt(x * x + y * y + z * z);
    double leastLost = Double.POSITIVE_INFINITY;
    double scale = 0;
    double from = 0;
    for (int n = 0; n < count; n++) {
      double distance = t - place[n];
      double filled = Math.abs(distance) / along[n] + aside / across[n];
      if (filled <= 1) {
        return false;
      }
      double lost = (1 - 1 / filled) * Math.sqrt(distance * distance + aside * aside);
      if (lost < leastLost) {
        leastLost = lost;
        scale = 1 / filled;
        from = place[n];
      }
    }
    if (leastLost == Double.POSITIVE_INFINITY) {
      boolean moved = change[0] != 0 || change[1] != 0 || change[2] != 0;
      Arrays.fill(change, 0);
      return moved;
    }
    double kept = from + (t - from) * scale;
    change[0] = kept * axis[0] + x * scale;
    change[1] = kept * axis[1] + y * scale;
    change[2] = kept * axis[2] + z * scale;
    return true;
  }
}
