package org.palpate.app.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.palpate.app.options.DeviceChoice;
import org.palpate.app.process.PalpateException;
import org.palpate.loop.LoopEnd;
import org.palpate.loop.LoopEnd.Cause;

/** However a session ends, it is told in one line that says what, where and what to do. */
class TouchEndingTest {
  private static final DeviceChoice REAL = DeviceChoice.parse("hid");

  @Test
  void aDeviceOrSolverThatThrewIsToldInOneLineWithExitCodeOne() {
    LoopEnd end = new LoopEnd(Cause.FAILED, new IllegalStateException("the cable"));
    assertTold(
        "the session failed (java.lang.IllegalStateException: the cable): device hid: run it again"
            + " with --debug and report what it shows",
        end,
        "");
  }

  @Test
  void aFrameThatDidNotComeBackIsToldInOneLineWithExitCodeOne() {
    assertTold(
        "a frame did not come back: device hid: force was ended by closing the device; look at its"
            + " cable and driver",
        new LoopEnd(Cause.HUNG, null),
        "");
  }

  @Test
  void aDeviceThatWentAwayIsToldInOneLineWithExitCodeOne() {
    assertTold(
        "the device went away (no report for 1 s): device hid: look at its cable and power; what it"
            + " still holds its own watchdog ends",
        new LoopEnd(Cause.DEVICE_GONE, null),
        "no report for 1 s");
  }

  @Test
  void aSessionThatWasStoppedEndsWithExitCodeZero() {
    assertEquals(0, TouchReport.exitCode(new LoopEnd(Cause.STOPPED, null), REAL, ""));
  }

  private static void assertTold(String line, LoopEnd end, String ending) {
    PalpateException told =
        assertThrows(PalpateException.class, () -> TouchReport.exitCode(end, REAL, ending));
    assertEquals(line, told.getMessage());
    assertFalse(told.getMessage().contains("\n"));
    assertEquals(PalpateException.FAILED, told.exitCode());
  }
}
