package org.palpate.frame;

import org.palpate.geometry.Vec3;

/**
 * Receives the result of each frame, for example {@code touchProperties::publish} of {@code sync}.
 * Haptic thread: an implementation allocates nothing and never waits.
 */
@FunctionalInterface
public interface FramePublisher {
  /** Ignores all results. */
  FramePublisher NONE = (device, point, force, contact, frame) -> {};

  /**
   * Receives the result of a frame. The vectors belong to the frame and change with the next one.
   *
   * @param device d, grid coordinates
   * @param point p, grid coordinates
   * @param forceNewton the force that was written to the device
   * @param contact whether there is contact
   * @param frame number of the frame, from 0
   */
  void publish(Vec3 device, Vec3 point, Vec3 forceNewton, boolean contact, long frame);
}
