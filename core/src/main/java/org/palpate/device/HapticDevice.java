package org.palpate.device;

import org.palpate.geometry.Vec3;

/**
 * A haptic device: read once and written once a frame, by the haptic thread.
 *
 * <p>Positions are world millimetres and forces newtons along the world's axes, after the device's
 * own frame was mapped to the world's.
 */
public interface HapticDevice extends AutoCloseable {

  DeviceSpecification specification();

  /**
   * Reads the newest sample without waiting longer than a fraction of a frame.
   *
   * @param state filled where the answer is {@link ReadStatus#FRESH}, else left as it was
   */
  ReadStatus read(DeviceState state);

  /**
   * Sends a force, in force until the next one.
   *
   * @param forceNewton on the hand; finite, already limited
   * @return false where the device could not be reached
   */
  boolean write(Vec3 forceNewton);

  /** One line: why nothing more comes from the device; empty while it does. Any thread. */
  default String ending() {
    return "";
  }

  /**
   * Sends zero force where the device can still be reached, then lets it go. May be called twice
   * and by any thread.
   */
  @Override
  void close();
}
