package org.palpate.loop;

import org.palpate.frame.FrameOutcome;
import org.palpate.frame.HapticFrame;

/**
 * Runs frames before a session until their time is steady, without a device that anyone holds, so
 * that the session's first frames find compiled code. What it drives is a frame of its own: same
 * solver and obstacles' classes, a simulated device over the same target, no publisher and no
 * recorder.
 *
 * <pre>
 *   settings.withWarmUp(new WarmUp(rehearsal, 10_000, 1_500_000_000L, NanoClock.SYSTEM))
 * </pre>
 */
public final class WarmUp implements Runnable {
  private static final long SIMULATED_PERIOD_NANOS = 1_000_000;

  private final HapticFrame rehearsal;
  private final int leastFrames;
  private final long budgetNanos;
  private final NanoClock clock;
  private long frames;
  private boolean gone;

  /**
   * A warm-up.
   *
   * @param rehearsal a frame over a simulated device; it reads the session's obstacles and must
   *     have no edits
   * @param leastFrames how many frames, at least, so that the hand has done all that it does
   * @param budgetNanos how long, at most
   */
  public WarmUp(HapticFrame rehearsal, int leastFrames, long budgetNanos, NanoClock clock) {
    this.rehearsal = rehearsal;
    this.leastFrames = leastFrames;
    this.budgetNanos = budgetNanos;
    this.clock = clock;
  }

  @Override
  public void run() {
    new SteadyWarmUp(clock).run(this::rehearse, leastFrames, budgetNanos);
  }

  private void rehearse() {
    if (!gone) {
      gone = rehearsal.run(frames++ * SIMULATED_PERIOD_NANOS) == FrameOutcome.DEVICE_GONE;
    }
  }
}
