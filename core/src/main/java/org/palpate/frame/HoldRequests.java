package org.palpate.frame;

import java.util.concurrent.atomic.AtomicReference;
import org.palpate.device.DeviceState;

/**
 * The newest request to take hold of a body or to let go of it, by a button of the device or by a
 * call. The haptic thread calls {@link #takeButton} and {@link #take}; {@link #request} is for any
 * thread.
 */
final class HoldRequests {
  private final AtomicReference<Request> newest = new AtomicReference<>(Request.NONE);
  private boolean isPressed;

  /** A change of what the hand holds. */
  enum Request {
    NONE,
    TAKE,
    LET_GO
  }

  /** Makes a request if the first button was pressed or released since the last call. */
  void takeButton(int buttons) {
    boolean pressed = (buttons & DeviceState.FIRST_BUTTON) != 0;
    if (pressed != isPressed) {
      isPressed = pressed;
      request(pressed ? Request.TAKE : Request.LET_GO);
    }
  }

  /** Replaces the request that waits. */
  void request(Request request) {
    newest.set(request);
  }

  /** Returns the request that waits, and leaves none. */
  Request take() {
    return newest.getAndSet(Request.NONE);
  }
}
