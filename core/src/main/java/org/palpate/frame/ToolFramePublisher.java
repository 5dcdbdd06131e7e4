package org.palpate.frame;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;

/**
 * Receives the result of each frame of a rigid tool. Haptic thread: an implementation allocates
 * nothing and never waits.
 */
@FunctionalInterface
public interface ToolFramePublisher {
  /** Ignores all results. */
  ToolFramePublisher NONE = (device, tool, force, torque, contact, frame) -> {};

  /**
   * Receives the result of a frame. Poses and vectors belong to the frame and change with the next
   * one.
   *
   * @param device the device pose, world mm
   * @param tool the tool pose, tool frame to world, mm
   * @param forceNewton the force that was written to the device, world axes
   * @param torqueNewtonMm the torque that was written, about the reference point, world axes
   * @param contact whether there is contact
   * @param frame number of the frame, from 0
   */
  void publish(
      Pose device, Pose tool, Vec3 forceNewton, Vec3 torqueNewtonMm, boolean contact, long frame);
}
