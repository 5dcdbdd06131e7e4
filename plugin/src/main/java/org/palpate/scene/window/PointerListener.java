package org.palpate.scene.window;

import org.palpate.geometry.Vec3;

/** Takes the mouse as a hand. Called on the thread that draws. */
@FunctionalInterface
public interface PointerListener {
  /**
   * The mouse is held down.
   *
   * @param worldMm where the hand wants to be, a little below the surface under the mouse
   */
  void moved(Vec3 worldMm);
}
