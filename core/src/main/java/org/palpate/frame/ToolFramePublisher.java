package org.palpate.frame;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.ToolMotion;

/**
 * Receives the result of each frame of a rigid tool. Haptic thread: an implementation allocates
 * nothing and never waits.
 */
@FunctionalInterface
public interface ToolFramePublisher {
  /** Ignores all results. */
  ToolFramePublisher NONE = (device, motion, force, torque, frame) -> {};

  /**
   * Receives the result of a frame. All of it belongs to the frame and changes with the next one.
   *
   * @param device the device pose, world mm
   * @param motion the tool pose and the contacts
   * @param forceNewton the force that was written to the device, world axes
   * @param torqueNewtonMm the torque that was written, about the reference point, world axes
   * @param frame number of the frame, from 0
   */
  void publish(Pose device, ToolMotion motion, Vec3 forceNewton, Vec3 torqueNewtonMm, long frame);
}
