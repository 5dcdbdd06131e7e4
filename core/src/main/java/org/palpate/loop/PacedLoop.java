package org.palpate.loop;

import java.util.concurrent.atomic.AtomicLong;
import org.palpate.frame.FrameCounters;
import org.palpate.frame.FrameOutcome;
import org.palpate.frame.HapticFrame;

/**
 * Paces frames by absolute deadlines and measures them; the loop without its thread. A late frame
 * is counted and what it missed is left out: the next deadline is the first of the even grid that
 * is at least half a period away, so that no burst of frames catches up.
 *
 * <p>One thread runs it; what is atomic any thread may read.
 */
final class PacedLoop {
  private final HapticFrame frame;
  private final LoopSettings settings;
  private final DurationRecorder period = new DurationRecorder();
  private final DurationRecorder work = new DurationRecorder();
  private final AtomicLong lateFrames = new AtomicLong();
  private final AtomicLong latenessNanos = new AtomicLong();
  private final AtomicLong firstBeganNanos = new AtomicLong();
  private final AtomicLong lastBeganNanos = new AtomicLong();
  private final AtomicLong frames = new AtomicLong();
  private volatile boolean begun;
  private volatile boolean stopAsked;

  PacedLoop(HapticFrame frame, LoopSettings settings) {
    this.frame = frame;
    this.settings = settings;
  }

  void askToStop() {
    stopAsked = true;
  }

  /** Runs frames until asked to stop or the device is gone. Throws what a frame throws. */
  LoopEnd.Cause run() {
    NanoClock clock = settings.clock();
    long deadline = clock.nanoTime();
    while (!stopAsked) {
      settings.pacer().awaitUntil(deadline);
      long began = clock.nanoTime();
      noteBeginning(began, began - deadline);
      FrameOutcome outcome = frame.run(began);
      work.record(clock.nanoTime() - began);
      frames.lazySet(frames.getPlain() + 1);
      if (outcome == FrameOutcome.DEVICE_GONE) {
        return LoopEnd.Cause.DEVICE_GONE;
      }
      deadline = next(deadline, began);
    }
    return LoopEnd.Cause.STOPPED;
  }

  private void noteBeginning(long began, long lateness) {
    if (begun) {
      period.record(began - lastBeganNanos.getPlain());
      lastBeganNanos.lazySet(began);
    } else {
      firstBeganNanos.set(began);
      lastBeganNanos.set(began);
      begun = true;
    }
    latenessNanos.lazySet(Math.max(0, lateness));
    if (lateness > settings.periodNanos() / 2) {
      lateFrames.lazySet(lateFrames.getPlain() + 1);
    }
  }

  private long next(long deadline, long began) {
    long periodNanos = settings.periodNanos();
    long late = began - deadline;
    if (late < -periodNanos) {
      return began + periodNanos; // The clock was set back: the old grid is of no use.
    }
    long missed = late > periodNanos / 2 ? (late + periodNanos / 2) / periodNanos : 0;
    return deadline + (missed + 1) * periodNanos;
  }

  /** Whether the first frame has begun; any thread. */
  boolean hasBegun() {
    return begun;
  }

  /** When the last frame began; any thread. */
  long lastBeganNanos() {
    return lastBeganNanos.get();
  }

  LoopStatus status() {
    FrameCounters tally = frame.tally();
    return new LoopStatus(
        tally.frames(),
        lateFrames.get(),
        latenessNanos.get(),
        tally.contactNow(),
        tally.forceNowNewton());
  }

  LoopReport report(ThreadSetup.Granted granted) {
    double seconds = (lastBeganNanos.get() - firstBeganNanos.get()) * 1e-9;
    long count = frames.get();
    return new LoopReport(
        seconds,
        seconds > 0 ? (count - 1) / seconds : 0,
        count,
        lateFrames.get(),
        period.quantiles(),
        work.quantiles(),
        granted,
        frame.counts());
  }
}
