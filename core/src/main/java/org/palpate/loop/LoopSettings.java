package org.palpate.loop;

/**
 * What a loop is set up with.
 *
 * @param periodNanos from one frame's deadline to the next one's, positive
 * @param clock where time comes from
 * @param pacer how the thread waits
 * @param threadSetup what makes the thread fit
 * @param warmUp run by the haptic thread before its first frame, so that the first frames find
 *     compiled code; see {@link WarmUp}
 * @param hangNanos how long a frame may take before the session is ended by force
 */
public record LoopSettings(
    long periodNanos,
    NanoClock clock,
    Pacer pacer,
    ThreadSetup threadSetup,
    Runnable warmUp,
    long hangNanos) {

  /** A thousand frames a second. */
  public static final long DEFAULT_PERIOD_NANOS = 1_000_000;

  /** Longer than any pause of a collector that a session should survive. */
  public static final long DEFAULT_HANG_NANOS = 1_000_000_000;

  /** Checks the ranges. */
  public LoopSettings {
    if (periodNanos <= 0 || hangNanos <= 0) {
      throw new IllegalArgumentException(
          "periods must be positive: periodNanos=" + periodNanos + " hangNanos=" + hangNanos);
    }
  }

  /** The machine's clock, sleep then spin, nothing asked of the system, no warm-up. */
  public static LoopSettings ofRate(double hertz) {
    return new LoopSettings(
        Math.round(1e9 / hertz),
        NanoClock.SYSTEM,
        new SleepThenSpinPacer(),
        ThreadSetup.NONE,
        () -> {},
        DEFAULT_HANG_NANOS);
  }

  /** The same with another way to wait and to set up the thread. */
  public LoopSettings with(Pacer newPacer, ThreadSetup newThreadSetup) {
    return new LoopSettings(periodNanos, clock, newPacer, newThreadSetup, warmUp, hangNanos);
  }

  /** The same with a warm-up. */
  public LoopSettings withWarmUp(Runnable newWarmUp) {
    return new LoopSettings(periodNanos, clock, pacer, threadSetup, newWarmUp, hangNanos);
  }
}
