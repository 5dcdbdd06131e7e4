package org.palpate.device;

import org.palpate.geometry.Vec3;

/**
 * A haptic device. The haptic thread reads and writes it once a frame.
 *
 * <p>Positions are in world millimetres, and forces and torques along the world's axes. {@link
 * WorkspaceDevice} maps a device's own frame to the world.
 */
public interface HapticDevice extends AutoCloseable {

  /** {@return the capabilities of the device} Any thread. */
  DeviceSpecification specification();

  /**
   * {@return whether the device can deliver samples} Most devices can as soon as they are open. The
   * first frame of a session waits until the device is ready. Haptic thread; never waits.
   */
  default boolean isReady() {
    return true;
  }

  /**
   * Reads the newest sample. It waits for a fraction of a frame at most.
   *
   * @param state filled if the result is {@link ReadStatus#FRESH}; else unchanged
   * @return whether there is a new sample, or why not
   */
  ReadStatus read(DeviceState state);

  /**
   * Sends a force and a torque, which the device exerts until the next ones.
   *
   * @param forceNewton on the hand; finite and already limited
   * @param torqueNewtonMm on the hand about the probe's position, N mm; finite and already limited.
   *     A device without torque ignores it.
   * @return false if the device could not be reached
   */
  boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm);

  /**
   * {@return one line on why the device delivers nothing more; empty while it works} Any thread.
   */
  default String ending() {
    return "";
  }

  /**
   * Sends zero force and torque if the device can still be reached, then releases the device. Any
   * thread; a second call does no harm.
   */
  @Override
  void close();
}
