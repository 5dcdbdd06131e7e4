package org.palpate.proxy.smooth.field;

import org.palpate.geometry.Vec3;

/**
 * The cell from which an {@link OccupancyField} searches the connected empty space. It holds the
 * point that decides which side of the solids counts. Mutable; one thread.
 */
public final class SeedCell {
  private int x;
  private int y;
  private int z;

  /**
   * Sets the cell that holds a position.
   *
   * @param position the position, grid coordinates
   * @return this cell
   */
  public SeedCell set(Vec3 position) {
    x = floor(position.x);
    y = floor(position.y);
    z = floor(position.z);
    return this;
  }

  /** Sets this to another cell. */
  void set(SeedCell other) {
    x = other.x;
    y = other.y;
    z = other.z;
  }

  /** {@return the cell's index along x} */
  public int x() {
    return x;
  }

  /** {@return the cell's index along y} */
  public int y() {
    return y;
  }

  /** {@return the cell's index along z} */
  public int z() {
    return z;
  }

  /** Whether both are the same cell. */
  boolean isSame(SeedCell other) {
    return x == other.x && y == other.y && z == other.z;
  }

  /** Returns the greatest whole number that is not above {@code v}, if it is an int. */
  static int floor(double v) {
    int whole = (int) v;
    return v < whole ? whole - 1 : whole;
  }
}
