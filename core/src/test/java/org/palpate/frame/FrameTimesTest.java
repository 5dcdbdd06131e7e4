package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.palpate.testing.ScriptedDevice.fresh;

import org.junit.jupiter.api.Test;
import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.force.ForceSettings;
import org.palpate.loop.ManualClock;
import org.palpate.testing.Floor;
import org.palpate.testing.ScriptedDevice;

/** The times, samples and writes that a frame counts. */
class FrameTimesTest {
  private static final long MS = ManualClock.MS;
  private static final double SLEW_NEWTON_PER_MS = 0.25;

  private final Floor floor = Floor.make();
  private long nowNanos = 3_600_000 * MS;

  @Test
  void noTimeHasPassedBeforeTheFirstFrame() {
    ScriptedDevice inTheFloor = ScriptedDevice.at(16.25, 16.25, 2);
    PointFrame frame = floor.frame(inTheFloor, slewed());
    run(frame, 1);
    assertEquals(0, inTheFloor.lastForce().length(), "the slew lets nothing through in no time");
    run(frame, 1);
    assertEquals(SLEW_NEWTON_PER_MS, inTheFloor.lastForce().length(), 1e-12);
  }

  @Test
  void theSlewCountsForAReportIntervalIfFramesRunInBetween() {
    ScriptedDevice device = pressesEveryFourMilliseconds();
    PointFrame frame = floor.frame(reporting(device, 4 * MS), slewed());
    run(frame, 1);
    assertEquals(0, device.lastForce().length());
    run(frame, 4);
    assertEquals(4 * SLEW_NEWTON_PER_MS, device.lastForce().z, 1e-12);
    run(frame, 3);
    assertEquals(4 * SLEW_NEWTON_PER_MS, device.lastForce().z, 1e-12, "held");
    run(frame, 1);
    assertEquals(8 * SLEW_NEWTON_PER_MS, device.lastForce().z, 1e-12);
  }

  @Test
  void reportsThatAreMissingDoNotLetTheForceRiseFaster() {
    ScriptedDevice device = pressesEveryFourMilliseconds();
    PointFrame frame = floor.frame(reporting(device, 2 * MS), slewed());
    run(frame, 5);
    assertEquals(2 * SLEW_NEWTON_PER_MS, device.lastForce().z, 1e-12);
  }

  /** Touches the floor at first, then presses 6 voxels into it, with a report in 4 ms. */
  private static ScriptedDevice pressesEveryFourMilliseconds() {
    return new ScriptedDevice(
        (read, state) ->
            read % 4 == 0 ? fresh(state, read, 16, 16, read == 0 ? 8.5 : 2) : ReadStatus.REPEATED);
  }

  private static HapticDevice reporting(HapticDevice device, long intervalNanos) {
    return new DeviceDecorator(device) {
      @Override
      public DeviceSpecification specification() {
        return new DeviceSpecification("slow", "", 10, 1, 100, intervalNanos);
      }
    };
  }

  private static FrameSettings slewed() {
    return new FrameSettings(
        ForceSettings.of(1, 0), Double.POSITIVE_INFINITY, SLEW_NEWTON_PER_MS, 0, 20 * MS, 64);
  }

  @Test
  void aDeviceThatIsReachedNowAndThenIsNotGone() {
    ScriptedDevice device = ScriptedDevice.at(16, 16, 20);
    PointFrame frame = floor.frame(device);
    for (int gap = 0; gap < 3; gap++) {
      device.reachable = false;
      run(frame, 15);
      device.reachable = true;
      run(frame, 1);
    }
    assertEquals(45, frame.statistics().faults().unreached());
  }

  @Test
  void aDeviceMayExertAForceIfTheLastOneWasNotZeroOrDidNotArrive() {
    ScriptedDevice device =
        new ScriptedDevice((read, state) -> fresh(state, read, 16, 16, read < 5 ? 20 : 5));
    PointFrame frame = floor.frame(device);
    run(frame, 1);
    assertFalse(frame.mayExertForce());
    device.reachable = false;
    run(frame, 1);
    assertTrue(frame.mayExertForce(), "the zero did not arrive");
    device.reachable = true;
    run(frame, 1);
    assertFalse(frame.mayExertForce());
    run(frame, 5);
    assertTrue(frame.mayExertForce(), "it presses");
    assertEquals(device.lastForce().length(), frame.forceLengthNewton());
  }

  @Test
  void changesBelongToTheNewSampleOfTheFrameOrElseToTheNextOne() {
    ScriptedDevice device =
        new ScriptedDevice(
            (read, state) -> read % 3 == 0 ? fresh(state, read, 16, 16, 20) : ReadStatus.REPEATED);
    PointFrame frame = floor.frame(device);
    long[] samples = {0, 1, 1, 1, 2, 2, 2};
    for (int n = 0; n < samples.length; n++) {
      run(frame, 1);
      assertEquals(samples[n], frame.sampleOfChanges(), "frame " + n);
      assertEquals(n % 3 == 0, frame.followed());
      assertEquals(n + 1, frame.frameCount());
    }
  }

  private void run(PointFrame frame, int frames) {
    for (int n = 0; n < frames; n++) {
      assertEquals(FrameOutcome.RUNNING, frame.run(nowNanos));
      nowNanos += MS;
    }
  }
}
