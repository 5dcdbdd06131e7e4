package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.force.ForceRamp;
import org.palpate.force.ForceSettings;
import org.palpate.frame.Watchdog.Verdict;

class WatchdogTest {
  private static final long MS = 1_000_000;
  private static final long SILENCE = 20 * MS;

  private final Watchdog watchdog = new Watchdog(SILENCE);
  private final DeviceState sample = new DeviceState();

  /** Judges a frame at a time, with a sample of another time at a place along x. */
  private Verdict fresh(long nowMs, long sampleMs, double x) {
    sample.positionMm.set(x, 0, 0);
    sample.timeNanos = sampleMs * MS;
    return watchdog.judge(ReadStatus.FRESH, sample, nowMs * MS);
  }

  private Verdict repeated(long nowMs) {
    return watchdog.judge(ReadStatus.REPEATED, sample, nowMs * MS);
  }

  @Test
  void newSamplesAreFollowed() {
    assertEquals(Verdict.FRESH, fresh(1, 5, 0));
    assertEquals(Verdict.FRESH, fresh(2, 6, 0));
    assertEquals(Verdict.FRESH, fresh(3, 6, 1), "the same time, but the hand moved");
    assertEquals(0, watchdog.held());
  }

  @Test
  void beforeTheFirstSampleNothingIsSilent() {
    for (int ms = 1; ms < 100; ms++) {
      assertEquals(Verdict.HELD, repeated(ms));
    }
    assertEquals(Verdict.FRESH, fresh(100, 0, 0), "there was no force to ramp");
    assertEquals(99, watchdog.held());
    assertEquals(0, watchdog.silences());
  }

  @Test
  void theForceIsHeldForTheSilenceAndThenDropped() {
    fresh(1, 1, 0);
    for (int ms = 2; ms <= 21; ms++) {
      assertEquals(Verdict.HELD, repeated(ms), "after " + (ms - 1) + " ms");
    }
    assertEquals(Verdict.SILENT, repeated(22), "after 21 ms");
    assertEquals(Verdict.SILENT, repeated(23));
    assertEquals(1, watchdog.silences());
    assertEquals(Verdict.RESUMED, fresh(24, 2, 0));
    assertEquals(Verdict.FRESH, fresh(25, 3, 0));
    assertEquals(22, watchdog.held());
  }

  @Test
  void afterASilenceAnyTimeIsNew() {
    fresh(1, 1000, 0);
    for (int ms = 2; ms < 30; ms++) {
      repeated(ms);
    }
    assertEquals(Verdict.RESUMED, fresh(30, 3, 0), "the device's clock was set back");
    assertEquals(Verdict.FRESH, fresh(31, 4, 0));
    assertEquals(0, watchdog.backwardTimes());
  }

  @Test
  void aSampleFromThePastIsHeldAndCounted() {
    fresh(1, 10, 0);
    assertEquals(Verdict.HELD, fresh(2, 9, 5));
    assertEquals(Verdict.FRESH, fresh(3, 10, 5), "not before the last new one");
    assertEquals(1, watchdog.backwardTimes());
    assertEquals(1, watchdog.held());
  }

  @Test
  void aPositionThatIsNotFiniteIsHeldAndCounted() {
    fresh(1, 1, 0);
    assertEquals(Verdict.HELD, fresh(2, 2, Double.NaN));
    assertEquals(Verdict.HELD, fresh(3, 3, Double.POSITIVE_INFINITY));
    assertEquals(2, watchdog.notFinite());
    for (int ms = 4; ms <= 21; ms++) {
      assertEquals(Verdict.HELD, fresh(ms, ms, Double.NaN));
    }
    assertEquals(Verdict.SILENT, fresh(22, 22, Double.NaN), "it is no sign of life");
    assertEquals(Verdict.SILENT, fresh(23, 23, Double.NaN));
    assertEquals(Verdict.RESUMED, fresh(24, 24, 0));
  }

  @Test
  void aClockThatHasRunAndStopsIsNoNewSample() {
    fresh(1, 7, 0);
    assertEquals(Verdict.FRESH, fresh(2, 7, 0), "the clock may not run at all");
    fresh(3, 8, 0);
    assertEquals(Verdict.HELD, fresh(4, 8, 0));
    assertEquals(1, watchdog.stoppedTimes());
    assertEquals(Verdict.FRESH, fresh(5, 8, 0.1), "the hand moved all the same");
    assertEquals(Verdict.FRESH, fresh(6, 9, 0.1));
  }

  @Test
  void aGapBetweenFramesIsASilence() {
    fresh(1, 1, 0);
    assertEquals(Verdict.FRESH, fresh(21, 2, 0), "exactly the silence");
    assertEquals(0, watchdog.gaps());
    assertEquals(Verdict.RESUMED, fresh(42, 3, 0), "a millisecond more");
    assertEquals(1, watchdog.gaps());
    assertEquals(Verdict.SILENT, repeated(63));
    assertEquals(2, watchdog.gaps());
    assertEquals(0, watchdog.silences(), "the device did not fall silent");
  }

  @Test
  void aGapBeforeTheFirstSampleIsNone() {
    repeated(1);
    assertEquals(Verdict.HELD, repeated(100));
    assertEquals(1, watchdog.gaps());
    assertEquals(Verdict.FRESH, fresh(101, 1, 0));
  }

  @Test
  void aFrameClockThatGoesBackRestartsTheSilence() {
    fresh(1000, 1, 0);
    repeated(1019);
    assertEquals(Verdict.HELD, repeated(500));
    assertEquals(1, watchdog.clockSetBacks());
    assertEquals(Verdict.HELD, repeated(520));
    assertEquals(Verdict.SILENT, repeated(521));
    assertEquals(0, watchdog.gaps());
  }

  @ParameterizedTest
  @CsvSource({"0, 20", "1, 20", "6, 20", "7, 21", "50, 150"})
  void aSlowDeviceMayBeSilentForThreeReports(long intervalMs, long silenceMs) {
    DeviceSpecification device = new DeviceSpecification("test", "", 3, 0.5, 50, intervalMs * MS);
    assertEquals(silenceMs * MS, Watchdog.silenceNanosFor(device));
    assertEquals(
        silenceMs * MS, FrameSettings.live(device, ForceSettings.of(0.5, 0.2)).silenceNanos());
  }

  @Test
  void liveSettingsAreThoseOfTheDevice() {
    FrameSettings live =
        FrameSettings.live(
            new DeviceSpecification("test", "", 8, 0.5, 50, MS), ForceSettings.of(0.5, 0.2));
    assertEquals(8, live.maxForceNewton());
    assertEquals(2, live.slewNewtonPerMs(), "full force in 4 ms");
    assertEquals(ForceRamp.DEFAULT_NANOS, live.rampNanos());
    assertEquals(2048, live.editVoxelsAFrame());
    assertEquals(5, live.withMaxForce(5).maxForceNewton());
    assertEquals(8, live.withMaxForce(9).maxForceNewton(), "never above the device's");
    assertEquals(2, live.withMaxForce(5).slewNewtonPerMs());
    FrameSettings torque = live.withTorque(70);
    assertEquals(70, torque.maxTorqueNewtonMm());
    assertEquals(Double.POSITIVE_INFINITY, torque.slewNewtonMmPerMs());
    assertEquals(8, torque.maxForceNewton());
  }

  @ParameterizedTest
  @CsvSource({"0, 1", "-1, 1", "1, 0"})
  void settingsThatCannotBeAreRefused(long silenceNanos, int voxels) {
    ForceSettings force = ForceSettings.of(0.5, 0.2);
    assertThrows(
        IllegalArgumentException.class,
        () -> new FrameSettings(force, 1, 1, 0, silenceNanos, voxels));
    new FrameSettings(force, 1, 1, 0, 1, 1);
  }
}
