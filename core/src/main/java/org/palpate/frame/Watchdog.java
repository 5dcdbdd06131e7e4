package org.palpate.frame;

import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;

/**
 * Judges what a device gave, frame by frame: whether it is a new sample, and if not, whether the
 * last force may still be held.
 *
 * <p>Not a new sample is: a repeated one, a position that is not finite, a time before the last
 * sample's, the same time and position again from a device whose clock has been seen to run. After
 * a silence any time is taken, so that a device whose clock was set back is not shut out for ever.
 *
 * <p>A gap between frames longer than the silence (a suspended machine, a hung read) is a silence
 * too. A frame clock that goes back starts the silence anew. Haptic thread; allocates nothing.
 */
public final class Watchdog {
  /** The least time without a sample that is a silence. */
  public static final long LEAST_SILENCE_NANOS = 20_000_000;

  /** How many report intervals of a slow device are a silence. */
  public static final int SILENT_REPORTS = 3;

  /** What a frame is to do. */
  public enum Verdict {
    /** A new sample: follow it. */
    FRESH,
    /** A new sample after a silence: follow it, with the force ramped from zero. */
    RESUMED,
    /** No new sample: hold the force. */
    HELD,
    /** No new sample for too long: no force. */
    SILENT
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

  /** Calls {@code silenceNanos} without a new sample a silence. */
  public Watchdog(long silenceNanos) {
    this.silenceNanos = silenceNanos;
  }

  /** 20 ms, or three report intervals where that is longer. */
  public static long silenceNanosFor(DeviceSpecification device) {
    return Math.max(LEAST_SILENCE_NANOS, SILENT_REPORTS * device.reportIntervalNanos());
  }

  /**
   * Judges one frame.
   *
   * @param status what the read said, not {@link ReadStatus#DISCONNECTED}
   * @param sample what it gave
   * @param nowNanos when the frame began
   */
  public Verdict judge(ReadStatus status, DeviceState sample, long nowNanos) {
    watchClock(nowNanos);
    if (status == ReadStatus.FRESH && isNew(sample)) {
      return accept(sample, nowNanos);
    }
    held++;
    if (!silent && sampled && nowNanos - lastFreshNanos > silenceNanos) {
      silent = true;
      silences++;
    }
    return silent ? Verdict.SILENT : Verdict.HELD;
  }

  private void watchClock(long nowNanos) {
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

  private boolean isNew(DeviceState sample) {
    if (!sample.positionMm.isFinite()) {
      notFinite++;
      return false;
    }
    if (!sampled || silent) {
      return true;
    }
    if (sample.timeNanos < lastSampleNanos) {
      backwardTimes++;
      return false;
    }
    boolean again =
        deviceClockRuns
            && sample.timeNanos == lastSampleNanos
            && sample.positionMm.sameBits(lastPosition);
    stoppedTimes += again ? 1 : 0;
    return !again;
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

  /** Frames without a new sample. */
  public long held() {
    return held;
  }

  /** Samples whose position was NaN or infinite. */
  public long notFinite() {
    return notFinite;
  }

  /** Samples with a time before the last one's. */
  public long backwardTimes() {
    return backwardTimes;
  }

  /** Samples that a device with a clock gave again. */
  public long stoppedTimes() {
    return stoppedTimes;
  }

  /** Times that the device fell silent. */
  public long silences() {
    return silences;
  }

  /** Gaps between frames that were longer than a silence. */
  public long gaps() {
    return gaps;
  }

  /** Times that the frame's own clock went back. */
  public long clockSetBacks() {
    return clockSetBacks;
  }
}
