package org.palpate.sync;

import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * A property that is a rigid transform, for example the pose of a tool. Starts with all components
 * zero, which is no valid transform.
 */
public final class TransformProperty extends Property {
  private static final int AXIS_Y = 3;
  private static final int AXIS_Z = 6;
  private static final int ORIGIN = 9;
  private static final int WORDS = 12;

  TransformProperty(Accumulator accumulator, String name, int index, int offset) {
    super(accumulator, name, index, offset, WORDS);
  }

  /**
   * Sets axes and origin. Writer.
   *
   * @param axisX the image of the x axis
   * @param axisY the image of the y axis
   * @param axisZ the image of the z axis
   * @param origin the image of the origin; all four are copied
   */
  public void set(Vec3 axisX, Vec3 axisY, Vec3 axisZ, Vec3 origin) {
    putVector(0, axisX);
    putVector(AXIS_Y, axisY);
    putVector(AXIS_Z, axisZ);
    putVector(ORIGIN, origin);
    settle();
  }

  /**
   * Sets axes and origin. Writer.
   *
   * @param value the new axes and origin; copied
   */
  public void set(RigidTransform value) {
    set(value.axisX(), value.axisY(), value.axisZ(), value.origin());
  }

  private void putVector(int word, Vec3 value) {
    put(word, value.x);
    put(word + 1, value.y);
    put(word + 2, value.z);
  }

  /**
   * Writes the value that was last taken. Reader.
   *
   * @param dest its four vectors are overwritten
   * @return {@code dest}
   */
  public RigidTransform read(RigidTransform dest) {
    readVector(0, dest.axisX());
    readVector(AXIS_Y, dest.axisY());
    readVector(AXIS_Z, dest.axisZ());
    readVector(ORIGIN, dest.origin());
    return dest;
  }

  /** {@return the value that was last taken} Allocates. Reader. */
  public RigidTransform read() {
    return read(RigidTransform.identity());
  }

  private void readVector(int word, Vec3 dest) {
    dest.set(takenDouble(word), takenDouble(word + 1), takenDouble(word + 2));
  }
}
