package org.palpate.sync;

import org.palpate.geometry.Vec3;

/** A polyline of up to a fixed number of points. Starts empty. */
public final class LinesProperty extends Property {
  private final int capacity;
  private int points;

  LinesProperty(Accumulator accumulator, String name, int index, int offset, int capacity) {
    super(accumulator, name, index, offset, 1 + 3 * capacity);
    if (capacity < 1) {
      throw new IllegalArgumentException("capacity must be at least 1: capacity=" + capacity);
    }
    this.capacity = capacity;
  }

  public int capacity() {
    return capacity;
  }

  /** Starts the line anew; {@link #end} must follow before the publication. Writer. */
  public LinesProperty begin() {
    points = 0;
    return this;
  }

  /** Adds a point; one beyond the capacity is left out. Writer. */
  public LinesProperty add(double x, double y, double z) {
    if (points < capacity) {
      int word = 1 + 3 * points++;
      put(word, x);
      put(word + 1, y);
      put(word + 2, z);
    }
    return this;
  }

  /** Ends the line that {@link #begin} started. Writer. */
  public void end() {
    put(0, (long) points);
    settle();
  }

  /** The number of points as last taken. Reader. */
  public int count() {
    return (int) taken(0);
  }

  /** Writes point {@code point} as last taken into {@code dest}. Reader. */
  public Vec3 read(int point, Vec3 dest) {
    int word = 1 + 3 * point;
    return dest.set(takenDouble(word), takenDouble(word + 1), takenDouble(word + 2));
  }
}
