package org.palpate.imagej.annotation;

import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;

/**
 * Counts the presses of the first button of a device; each adds a landmark. The haptic thread reads
 * the device, one other thread polls the presses.
 */
public final class LandmarkButton extends DeviceDecorator {
  private static final int FIRST_BUTTON = 1;

  private boolean wasPressed;
  private volatile int presses;
  private int polled;

  /** Wraps a device. */
  public LandmarkButton(HapticDevice device) {
    super(device);
  }

  @Override
  public ReadStatus read(DeviceState state) {
    ReadStatus status = super.read(state);
    if (status == ReadStatus.FRESH) {
      boolean pressed = (state.buttons & FIRST_BUTTON) != 0;
      if (pressed && !wasPressed) {
        countOne();
      }
      wasPressed = pressed;
    }
    return status;
  }

  /** Only the haptic thread writes the counter. */
  @SuppressWarnings("NonAtomicVolatileUpdate")
  private void countOne() {
    presses++;
  }

  /** Returns the number of presses since the last call. */
  public int pollPresses() {
    int now = presses;
    int fresh = now - polled;
    polled = now;
    return fresh;
  }
}
