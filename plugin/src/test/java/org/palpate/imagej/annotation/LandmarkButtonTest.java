package org.palpate.imagej.annotation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.device.ReplayDevice;
import org.palpate.device.Trajectory;

/** The first button of a device adds landmarks. */
class LandmarkButtonTest {
  private int buttons;
  private ReadStatus status = ReadStatus.FRESH;
  private final LandmarkButton button = new LandmarkButton(new Scripted());

  /** A device whose buttons the test presses. */
  private final class Scripted extends DeviceDecorator {
    private Scripted() {
      super(new ReplayDevice("none", new Trajectory()));
    }

    @Override
    public ReadStatus read(DeviceState state) {
      state.buttons = buttons;
      return status;
    }
  }

  @Test
  void countsAHeldButtonOnceAndIgnoresOtherButtons() {
    for (int pressed : List.of(0, 1, 1, 1, 0, 2, 6, 7, 0)) {
      read(pressed, ReadStatus.FRESH);
    }
    assertEquals(2, button.pollPresses());
    assertEquals(0, button.pollPresses());
  }

  @Test
  void ignoresReadsWithoutAFreshSample() {
    read(1, ReadStatus.REPEATED);
    assertEquals(0, button.pollPresses());
    read(1, ReadStatus.FRESH);
    assertEquals(1, button.pollPresses());
  }

  private void read(int pressed, ReadStatus answer) {
    buttons = pressed;
    status = answer;
    button.read(new DeviceState());
  }
}
