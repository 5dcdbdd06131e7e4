package org.palpate.proxy;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.statistics.SkipCounters;

/**
 * Moves the interaction point after the device, once a frame. Keeps scratch: haptic thread only.
 */
public interface ProxySolver {
  /**
   * Runs one frame: clears the legs, moves {@code point} towards {@code device} by legs of at most
   * w_max together, and says whether there was contact.
   *
   * @param obstacles the solids of this frame
   * @param device where the device is, grid coordinates, finite
   * @param point moved; touches no solid when the frame begins
   */
  void follow(CollisionScene obstacles, Vec3 device, InteractionPoint point);

  /**
   * Forgets what is kept from frame to frame, after the point was placed anew or solids changed.
   */
  default void reset() {}

  /** Adds how often this solver has left out what to {@code dest}. */
  default void addSkips(SkipCounters dest) {}
}
