package org.palpate.device;

import org.palpate.geometry.Vec3;

/**
 * A haptic device. The haptic thread reads and writes it once a frame.
 *
 * <p>Positions are in world millimetres, and forces in newtons along the world's axes. {@link
 * WorkspaceDevice} maps a device's own frame to the world.
 */
public interface HapticDevice extends AutoCloseable {

  /** Returns the capabilities of the device. Any thread. */
  DeviceSpecification specification();

  /**
   * Reads the newest sample. It waits for a fraction of a frame at most.
   *
   * @param state filled if the result is {@link ReadStatus#FRESH}; else unchanged
   */
  ReadStatus read(DeviceState state);

  /**
   * Sends a force, which the device exerts until the next one.
   *
   * @param forceNewton on the hand; finite and already limited
   * @return false if the device could not be reached
   */
  boolean write(Vec3 forceNewton);

  /** Returns one line on why the device delivers nothing more; empty while it works. Any thread. */
  default String ending() {
    return "";
  }

  /**
   * Sends zero force if the device can still be reached, then releases the device. Any thread; a
   * second call does no harm.
   */
  @Override
  void close();
}
