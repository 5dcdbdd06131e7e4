package org.palpate.app.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.app.options.DeviceChoice;
import org.palpate.app.process.PalpateException;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.device.SimulatedDevice;
import org.palpate.geometry.Vec3;
import org.palpate.host.MouseTakeover;
import org.palpate.loop.LoopEnd;
import org.palpate.loop.LoopEnd.Cause;
import org.palpate.loop.Quantiles;

/** Every ending is reported in one line with what, where and what to do. */
class TouchReportTest {
  private static final DeviceChoice REAL = DeviceChoice.parse("hid");

  @Test
  void reportsAFailedDeviceOrSolverInOneLineWithExitCodeOne() {
    LoopEnd end = new LoopEnd(Cause.FAILED, new IllegalStateException("the cable"));
    assertReports(
        "the session failed (java.lang.IllegalStateException: the cable): device hid: run it again"
            + " with --debug and report the output",
        end,
        "");
  }

  @Test
  void memoryThatRanOutIsLeftToTheLineThatSaysHowToGetMore() {
    OutOfMemoryError tooLittle = new OutOfMemoryError("Java heap space");
    LoopEnd end = new LoopEnd(Cause.FAILED, tooLittle);
    assertSame(
        tooLittle, assertThrows(OutOfMemoryError.class, () -> TouchReport.exitCode(end, REAL, "")));
  }

  @Test
  void reportsAHapticThreadThatStoodStillInOneLineWithExitCodeOne() {
    assertReports(
        "no frame began for more than a second: device hid: the force was ended by closing the"
            + " device; check its cable and driver, and what else keeps the processors busy",
        new LoopEnd(Cause.HUNG, null),
        "");
  }

  @Test
  void reportsADisconnectedDeviceInOneLineWithExitCodeOne() {
    assertReports(
        "the device disconnected (no report for 1 s): device hid: check its cable and power; its"
            + " own watchdog ends any remaining force",
        new LoopEnd(Cause.DEVICE_GONE, null),
        "no report for 1 s");
  }

  @Test
  void aStoppedSessionHasExitCodeZero() {
    assertEquals(0, TouchReport.exitCode(new LoopEnd(Cause.STOPPED, null), REAL, ""));
  }

  @Test
  void theSummaryShowsTheWorstLateness() {
    assertEquals(
        "lateness 3.2 us, 99 % under 41.0 us, at most 1234.5 us",
        TouchReport.lateness(new Quantiles(3.2, 41, 300, 1234.5)));
  }

  @Test
  void aSimulatedHandAndARecordingAreNoPerson() {
    HandTarget target =
        new HandTarget(new Vec3(), new Vec3(9, 9, 9), 1, List.of(new Vec3(5, 5, 5)));
    HapticDevice hand = new SimulatedDevice(1, target, 1_000_000);
    assertTrue(TouchReport.isByHand(REAL, hand));
    assertTrue(TouchReport.isByHand(DeviceChoice.parse("mouse"), hand));
    assertFalse(TouchReport.isByHand(DeviceChoice.parse("simulated:3"), hand));
    assertFalse(TouchReport.isByHand(DeviceChoice.parse("replay:t.csv"), hand));
    try (MouseTakeover takeover = new MouseTakeover(hand, target, 1_000_000)) {
      assertFalse(TouchReport.isByHand(DeviceChoice.parse("simulated"), takeover));
    }
  }

  private static void assertReports(String line, LoopEnd end, String ending) {
    PalpateException error =
        assertThrows(PalpateException.class, () -> TouchReport.exitCode(end, REAL, ending));
    assertEquals(line, error.getMessage());
    assertFalse(error.getMessage().contains("\n"));
    assertEquals(PalpateException.FAILED, error.exitCode());
  }
}
