package org.palpate.sync;

import org.palpate.geometry.Vec3;

/** A property of three doubles that belong together, for example a position. Starts at zero. */
public final class PositionProperty extends Property {
  PositionProperty(Accumulator accumulator, String name, int index, int offset) {
    super(accumulator, name, index, offset, 3);
  }

  /**
   * Sets the three components. Writer.
   *
   * @param x the component along x
   * @param y the component along y
   * @param z the component along z
   */
  public void set(double x, double y, double z) {
    putAll(x, y, z);
  }

  /**
   * Sets the three components. Writer.
   *
   * @param value the new components; copied
   */
  public void set(Vec3 value) {
    set(value.x, value.y, value.z);
  }

  /**
   * Writes the value that was last taken. Reader.
   *
   * @param dest receives the value
   * @return {@code dest}
   */
  public Vec3 read(Vec3 dest) {
    return dest.set(takenDouble(0), takenDouble(1), takenDouble(2));
  }
}
