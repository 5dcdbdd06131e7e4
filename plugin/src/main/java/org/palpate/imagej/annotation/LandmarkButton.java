package org.palpate.imagej.annotation;

import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;

/**
 * Counts how often the first button of a device was pressed, each time for a landmark. Read by the
 * haptic thread, asked by any one other.
 */
public final class LandmarkButton extends DeviceDecorator {
  private static final int FIRST_BUTTON = 1;

  private boolean held;
  private volatile int presses;
  private int taken;

  public LandmarkButton(HapticDevice device) {
    super(device);
  }

  @Override
  public ReadStatus read(DeviceState state) {
    ReadStatus status = super.read(state);
    if (status == ReadStatus.FRESH) {
      boolean pressed = (state.buttons & FIRST_BUTTON) != 0;
      if (pressed && !held) {
        countOne();
      }
      held = pressed;
    }
    return status;
  }

  /** The haptic thread alone writes it. */
  @SuppressWarnings("NonAtomicVolatileUpdate")
  private void countOne() {
    presses++;
  }

  /** How often it was pressed since this was asked last. */
  public int pollPresses() {
    int now = presses;
    int fresh = now - taken;
    taken = now;
    return fresh;
  }
}
