package org.palpate.loop;

import java.util.function.BooleanSupplier;
import org.palpate.device.HapticDevice;
import org.palpate.frame.FrameOutcome;
import org.palpate.frame.HapticFrame;

/**
 * Runs frames before a session until their time is steady, so that the session's first frames find
 * compiled code.
 *
 * <p>It drives a frame of its own: the same classes of solver and scene, a simulated device over
 * the same target, no publisher and no recorder. No person holds a device meanwhile. It ends early
 * if the thread is interrupted.
 *
 * <pre>
 *   settings.withWarmUp(WarmUp.ofSession(rehearsal, device))
 * </pre>
 */
public final class WarmUp implements Runnable {
  /**
   * The time between two frames of the rehearsal. At any rate of the session it is that for which
   * the least number of frames shows every gesture.
   */
  public static final long PERIOD_NANOS = 1_000_000;

  /** In so many frames the simulated hand makes every gesture. */
  private static final int SESSION_MIN_FRAMES = 10_000;

  /**
   * The longest warm-up of a session. On an idle machine the JVM's second compiler is done with the
   * frames of a point after one to two seconds.
   */
  private static final long SESSION_BUDGET_NANOS = 2_000_000_000L;

  private final HapticFrame rehearsal;
  private final int minFrames;
  private final long budgetNanos;
  private final NanoClock clock;
  private final BooleanSupplier othersPrepare;
  private long frames;
  private boolean gone;

  /**
   * Makes a warm-up.
   *
   * @param rehearsal a frame over a simulated device with {@link #PERIOD_NANOS}; it reads the
   *     session's scene and has no edits
   * @param minFrames the least number of frames, so that the hand makes every gesture
   * @param budgetNanos the longest time to take
   * @param clock measures the time taken
   */
  public WarmUp(HapticFrame rehearsal, int minFrames, long budgetNanos, NanoClock clock) {
    this(rehearsal, minFrames, budgetNanos, clock, () -> false);
  }

  private WarmUp(
      HapticFrame rehearsal,
      int minFrames,
      long budgetNanos,
      NanoClock clock,
      BooleanSupplier othersPrepare) {
    this.rehearsal = rehearsal;
    this.minFrames = minFrames;
    this.budgetNanos = budgetNanos;
    this.clock = clock;
    this.othersPrepare = othersPrepare;
  }

  /**
   * {@return the warm-up of a session, which takes two seconds at most} As long as the device is
   * not ready, it leaves half of the time to what prepares the device.
   *
   * @param rehearsal a frame over a simulated device with {@link #PERIOD_NANOS}; it reads the
   *     session's scene and has no edits
   * @param device the device of the session, which the warm-up does not read
   */
  public static WarmUp ofSession(HapticFrame rehearsal, HapticDevice device) {
    return new WarmUp(
        rehearsal,
        SESSION_MIN_FRAMES,
        SESSION_BUDGET_NANOS,
        NanoClock.SYSTEM,
        () -> !device.isReady());
  }

  @Override
  public void run() {
    new SteadyWarmUp(clock, othersPrepare).run(this::rehearse, minFrames, budgetNanos);
  }

  private void rehearse() {
    if (!gone) {
      gone = rehearsal.run(frames++ * PERIOD_NANOS) == FrameOutcome.DEVICE_GONE;
    }
  }
}
