package org.palpate.device;

import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * One sample of a device. A mutable carrier. Nothing is checked: a position or an orientation may
 * be NaN.
 *
 * <p>The device states its frame; {@link HapticDevice} uses world millimetres.
 */
public final class DeviceState {
  /** The bit of the first button. A rigid tool takes hold of a body as long as it is pressed. */
  public static final int FIRST_BUTTON = 1;

  /** Position of the probe, mm. */
  public final Vec3 positionMm = new Vec3();

  /** Orientation of the probe, of norm 1; the identity if the device has none. */
  public final Quaternion orientation = new Quaternion();

  /** Time of the sample on the device's own clock. */
  public long timeNanos;

  /** Pressed buttons; bit 0 is the first button. */
  public int buttons;

  /**
   * Whether the probe was put at this position without a motion that leads to it. The frame then
   * sets its tool free there. Only a device without a hand, such as a mouse, does this.
   */
  public boolean relocated;

  /**
   * Copies another state.
   *
   * @param other the state to copy
   * @return this state
   */
  public DeviceState set(DeviceState other) {
    positionMm.set(other.positionMm);
    orientation.set(other.orientation);
    timeNanos = other.timeNanos;
    buttons = other.buttons;
    relocated = other.relocated;
    return this;
  }
}
