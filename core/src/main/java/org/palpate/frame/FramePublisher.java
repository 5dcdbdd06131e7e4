package org.palpate.frame;

import org.palpate.geometry.Vec3;

/**
 * Where a frame puts what it did, in the haptic thread: {@code touchProperties::publish} of {@code
 * sync}, or nowhere. Must allocate nothing and never wait.
 */
@FunctionalInterface
public interface FramePublisher {
  /** Nowhere. */
  FramePublisher NONE = (device, point, force, contact, frame) -> {};

  /**
   * Takes a frame's result; the vectors are the frame's own and change with the next.
   *
   * @param device d, grid coordinates
   * @param point p, grid coordinates
   * @param forceNewton what was written to the device
   * @param contact whether there is contact
   * @param frame its number, from 0
   */
  void publish(Vec3 device, Vec3 point, Vec3 forceNewton, boolean contact, long frame);
}
