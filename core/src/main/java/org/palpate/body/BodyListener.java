package org.palpate.body;

import org.palpate.geometry.Pose;

/**
 * Receives each new pose of a body and the event that caused it. Haptic thread: an implementation
 * allocates nothing.
 */
@FunctionalInterface
public interface BodyListener {
  /** Ignores everything. */
  BodyListener NONE = (body, event, pose, inHand) -> {};

  /**
   * Receives an event after it happened.
   *
   * @param body index of the body in its scene
   * @param event what happened to the body
   * @param pose the body's pose as committed, from rest to present, world mm; not to be kept
   * @param inHand the pose of the body's reference point relative to the device, constant from
   *     {@link BodyEvent#TAKEN} on as long as it is held; of no meaning for other events
   */
  void accept(int body, BodyEvent event, Pose pose, Pose inHand);
}
