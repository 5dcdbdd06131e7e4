package org.palpate.device;

import org.palpate.geometry.Vec3;

/** One sample of a device. What it sent, unchecked: a position may be NaN. Mutable carrier. */
public final class DeviceState {
  /** Position of the probe, world mm. */
  public final Vec3 positionMm = new Vec3();

  /** Orientation as a unit quaternion; (0,0,0,1) where the device has none. */
  public double qx;

  public double qy;
  public double qz;
  public double qw = 1;

  /** When the device says that it took the sample, nanoseconds on a clock of its own. */
  public long timeNanos;

  /** Pressed buttons, bit 0 the first. */
  public int buttons;

  /** Copies the other state. */
  public DeviceState set(DeviceState other) {
    positionMm.set(other.positionMm);
    qx = other.qx;
    qy = other.qy;
    qz = other.qz;
    qw = other.qw;
    timeNanos = other.timeNanos;
    buttons = other.buttons;
    return this;
  }
}
