package org.palpate.frame;

import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;

/**
 * Judges the sample of each frame: whether it is new, and if not, whether the last force may still
 * be held.
 *
 * <p>A sample is not new if it is repeated, if its position is not finite, or if its time is before
 * that of the last sample. Nor is it new if a device whose clock is known to run sends the last
 * time and position again. After a silence any time counts as new, so that a device whose clock was
 * set back works again.
 *
 * <p>A gap between frames that is longer than the silence counts as a silence, for example a
 * suspended machine or a read that hangs. A frame clock that goes back restarts the silence.
 *
 * <p>Haptic thread; allocates nothing.
 */
public final class Watchdog {
  /** The shortest silence. */
  public static final long MIN_SILENCE_NANOS = 20_000_000;

  /** The silence of a slow device, in report intervals. */
  public static final int SILENT_REPORTS = 3;

  /** The decision about a frame. */
  public enum Verdict {
    /** A new sample: the point follows it. */
    FRESH,
    /** A new sample after a silence: the point follows it, and the force rises from zero. */
    RESUMED,
    /** No new sample: the force is held. */
    HELD,
    /** No new sample for the time of a silence: the force is dropped. */
    SILENT
  }

  private enum SampleKind {
    NEW,
    REPEATED,
    NOT_FINITE,
    BACKWARD_TIME,
    STOPPED_TIME
  }

  private final long silenceNanos;
  private boolean begun;
  private boolean sampled;
  private boolean silent;
  private boolean deviceClockRuns;
  private long lastFrameNanos;
  private long lastFreshNanos;
  private long lastSampleNanos;
  private final Vec3 lastPosition = new Vec3();

  private long held;
  private long notFinite;
  private long backwardTimes;
  private long stoppedTimes;
  private long silences;
  private long gaps;
  private long clockSetBacks;

  /**
   * Makes a watchdog before its first frame.
   *
   * @param silenceNanos the time without a new sample that counts as a silence
   */
  public Watchdog(long silenceNanos) {
    this.silenceNanos = silenceNanos;
  }

  /**
   * {@return the time without a new sample after which a device counts as silent, ns: 20 ms, or
   * three report intervals if that is longer}
   *
   * @param device states the interval of its reports
   */
  public static long silenceNanosFor(DeviceSpecification device) {
    return Math.max(MIN_SILENCE_NANOS, SILENT_REPORTS * device.reportIntervalNanos());
  }

  /**
   * Judges one frame and counts its fault.
   *
   * @param status result of the read, not {@link ReadStatus#DISCONNECTED}
   * @param sample the device's last sample
   * @param nowNanos the beginning of the frame
   * @return whether the sample is new, and whether the last force may be held
   */
  public Verdict judge(ReadStatus status, DeviceState sample, long nowNanos) {
    updateFrameClock(nowNanos);
    SampleKind kind = status == ReadStatus.FRESH ? kindOf(sample) : SampleKind.REPEATED;
    if (kind == SampleKind.NEW) {
      return accept(sample, nowNanos);
    }
    count(kind);
    return holdUntilSilence(nowNanos);
  }

  private void updateFrameClock(long nowNanos) {
    long sinceLast = begun ? nowNanos - lastFrameNanos : 0;
    begun = true;
    lastFrameNanos = nowNanos;
    if (sinceLast < 0) {
      clockSetBacks++;
      lastFreshNanos = nowNanos;
    } else if (sinceLast > silenceNanos) {
      gaps++;
      silent = sampled;
    }
  }

  private SampleKind kindOf(DeviceState sample) {
    if (!sample.positionMm.isFinite()) {
      return SampleKind.NOT_FINITE;
    }
    if (!sampled || silent) {
      return SampleKind.NEW;
    }
    if (sample.timeNanos < lastSampleNanos) {
      return SampleKind.BACKWARD_TIME;
    }
    boolean clockStopped =
        deviceClockRuns
            && sample.timeNanos == lastSampleNanos
            && sample.positionMm.sameBits(lastPosition);
    return clockStopped ? SampleKind.STOPPED_TIME : SampleKind.NEW;
  }

  private Verdict accept(DeviceState sample, long nowNanos) {
    deviceClockRuns |= sampled && sample.timeNanos > lastSampleNanos;
    boolean resumed = silent;
    sampled = true;
    silent = false;
    lastFreshNanos = nowNanos;
    lastSampleNanos = sample.timeNanos;
    lastPosition.set(sample.positionMm);
    return resumed ? Verdict.RESUMED : Verdict.FRESH;
  }

  private void count(SampleKind kind) {
    held++;
    notFinite += kind == SampleKind.NOT_FINITE ? 1 : 0;
    backwardTimes += kind == SampleKind.BACKWARD_TIME ? 1 : 0;
    stoppedTimes += kind == SampleKind.STOPPED_TIME ? 1 : 0;
  }

  private Verdict holdUntilSilence(long nowNanos) {
    if (!silent && sampled && nowNanos - lastFreshNanos > silenceNanos) {
      silent = true;
      silences++;
    }
    return silent ? Verdict.SILENT : Verdict.HELD;
  }

  /** {@return the number of frames without a new sample} */
  public long held() {
    return held;
  }

  /** {@return the number of samples whose position was NaN or infinite} */
  public long notFinite() {
    return notFinite;
  }

  /** {@return the number of samples with a time before that of the last sample} */
  public long backwardTimes() {
    return backwardTimes;
  }

  /** {@return the number of samples that a device with a clock delivered again} */
  public long stoppedTimes() {
    return stoppedTimes;
  }

  /** {@return the number of silences of the device} */
  public long silences() {
    return silences;
  }

  /** {@return the number of gaps between frames that were longer than a silence} */
  public long gaps() {
    return gaps;
  }

  /** {@return the number of times that the frame's own clock went back} */
  public long clockSetBacks() {
    return clockSetBacks;
  }
}
