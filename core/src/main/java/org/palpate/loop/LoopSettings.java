package org.palpate.loop;

/**
 * The settings of a loop.
 *
 * @param periodNanos time from one deadline to the next, positive
 * @param clock the source of time
 * @param pacer waits for the deadlines
 * @param threadSetup prepares the haptic thread
 * @param warmUp runs in the haptic thread before its first frame, so that the first frames find
 *     compiled code; should end early if the thread is interrupted, see {@link WarmUp}
 * @param hangNanos time that may pass after the start of a frame before {@link
 *     HapticLoop#supervise} ends the session by force, positive
 */
public record LoopSettings(
    long periodNanos,
    NanoClock clock,
    Pacer pacer,
    ThreadSetup threadSetup,
    Runnable warmUp,
    long hangNanos) {

  /** The usual period: a thousand frames a second. */
  public static final long DEFAULT_PERIOD_NANOS = 1_000_000;

  /** The usual limit, longer than any pause of a garbage collector that a session survives. */
  public static final long DEFAULT_HANG_NANOS = 1_000_000_000;

  /**
   * Checks the ranges.
   *
   * @throws IllegalArgumentException if a period is not positive
   */
  public LoopSettings {
    if (periodNanos <= 0 || hangNanos <= 0) {
      throw new IllegalArgumentException(
          "periods must be positive: periodNanos=" + periodNanos + " hangNanos=" + hangNanos);
    }
  }

  /**
   * {@return settings with the JDK's clock and waits, without thread set-up and warm-up}
   *
   * @param hertz the number of frames in a second
   */
  public static LoopSettings ofRate(double hertz) {
    return new LoopSettings(
        Math.round(1e9 / hertz),
        NanoClock.SYSTEM,
        new SleepThenSpinPacer(),
        ThreadSetup.NONE,
        () -> {},
        DEFAULT_HANG_NANOS);
  }

  /**
   * {@return these settings with another pacer and thread set-up}
   *
   * @param newPacer waits for the time of each frame
   * @param newThreadSetup prepares the haptic thread
   */
  public LoopSettings with(Pacer newPacer, ThreadSetup newThreadSetup) {
    return new LoopSettings(periodNanos, clock, newPacer, newThreadSetup, warmUp, hangNanos);
  }

  /**
   * {@return these settings with a warm-up, after which the pacer takes a rest that is due}
   *
   * @param newWarmUp runs on the haptic thread before the first frame
   */
  public LoopSettings withWarmUp(Runnable newWarmUp) {
    Runnable rested =
        () -> {
          newWarmUp.run();
          pacer.awaitUntil(clock.nanoTime());
        };
    return new LoopSettings(periodNanos, clock, pacer, threadSetup, rested, hangNanos);
  }
}
