package org.palpate.interaction;

/**
 * Runs frames before a session, without a device that anyone holds, so that the session's first
 * frames find compiled code. What it drives is a frame of its own: same solver and obstacles'
 * classes, a simulated device over the same target, no publisher and no recorder.
 *
 * <pre>
 *   settings.withWarmUp(new WarmUp(rehearsal, 30_000, 1_500_000_000L, NanoClock.SYSTEM))
 * </pre>
 */
public final class WarmUp implements Runnable {
  private static final long SIMULATED_PERIOD_NANOS = 1_000_000;

  private final HapticFrame rehearsal;
  private final int frames;
  private final long budgetNanos;
  private final NanoClock clock;

  /**
   * A warm-up.
   *
   * @param rehearsal a frame over a simulated device; it reads the session's obstacles and must
   *     have no edits
   * @param frames how many frames, at most
   * @param budgetNanos how long, at most
   */
  public WarmUp(HapticFrame rehearsal, int frames, long budgetNanos, NanoClock clock) {
    this.rehearsal = rehearsal;
    this.frames = frames;
    this.budgetNanos = budgetNanos;
    this.clock = clock;
  }

  @Override
  public void run() {
    long began = clock.nanoTime();
    for (int frame = 0; frame < frames; frame++) {
      FrameOutcome outcome = rehearsal.run(frame * SIMULATED_PERIOD_NANOS);
      boolean over = outcome == FrameOutcome.DEVICE_GONE || clock.nanoTime() - began > budgetNanos;
      if (over) {
        return;
      }
    }
  }
}
