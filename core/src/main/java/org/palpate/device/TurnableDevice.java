package org.palpate.device;

import org.palpate.geometry.Vec3;

/** A device whose orientation a program turns, because its own samples do not turn. */
public interface TurnableDevice extends HapticDevice {
  /**
   * Requests a turn after those that were requested before; the orientation follows smoothly. Any
   * thread.
   *
   * @param rotationVector axis times angle, world axes, rad; finite, at most pi in length
   */
  void turn(Vec3 rotationVector);

  /** {@return whether a turn that is requested now has an effect} Any thread. */
  default boolean isTurnable() {
    return true;
  }
}
