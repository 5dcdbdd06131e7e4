package org.palpate.scene.window;

import org.palpate.geometry.Vec3;

/** Receives the mouse as a device. Called on the thread that draws. */
@FunctionalInterface
public interface PointerListener {
  /**
   * Receives a position while the mouse button is held down.
   *
   * @param worldMm the target of the device, slightly below the surface under the mouse, world mm
   */
  void moved(Vec3 worldMm);
}
