package org.palpate.sync;

import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/** A rigid transform: three axes and an origin. Starts as all zeros, which is none. */
public final class TransformProperty extends Property {
  private static final int ORIGIN = 9;

  TransformProperty(Accumulator accumulator, String name, int index, int offset) {
    super(accumulator, name, index, offset, 12);
  }

  /** Sets axes and origin. Writer. */
  public void set(Vec3 axisX, Vec3 axisY, Vec3 axisZ, Vec3 origin) {
    put3(0, axisX);
    put3(3, axisY);
    put3(6, axisZ);
    put3(ORIGIN, origin);
    settle();
  }

  public void set(RigidTransform value) {
    set(value.axisX(), value.axisY(), value.axisZ(), value.origin());
  }

  private void put3(int word, Vec3 value) {
    put(word, value.x);
    put(word + 1, value.y);
    put(word + 2, value.z);
  }

  /** Writes the value as last taken into the four. Reader. */
  public void read(Vec3 axisX, Vec3 axisY, Vec3 axisZ, Vec3 origin) {
    read3(0, axisX);
    read3(3, axisY);
    read3(6, axisZ);
    read3(ORIGIN, origin);
  }

  /** The value as last taken; allocates. Reader. */
  public RigidTransform read() {
    RigidTransform dest = new RigidTransform(new Vec3(), new Vec3(), new Vec3(), new Vec3());
    read(dest.axisX(), dest.axisY(), dest.axisZ(), dest.origin());
    return dest;
  }

  private void read3(int word, Vec3 dest) {
    dest.set(takenDouble(word), takenDouble(word + 1), takenDouble(word + 2));
  }
}
