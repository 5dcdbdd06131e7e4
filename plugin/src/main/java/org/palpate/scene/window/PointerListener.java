package org.palpate.scene.window;

/** Receives the mouse as a device. Called on the thread that draws. */
public interface PointerListener {
  /**
   * Receives a spot while the mouse button is held down.
   *
   * @return whether there is something to touch; if not, a drag that begins here turns the scene
   */
  boolean press(PointerSpot spot);

  /** Reports that a press began on the background, where there is nothing to touch. */
  void pressedBackground();
}
