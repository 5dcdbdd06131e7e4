package org.palpate.loop;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import org.palpate.frame.FrameOutcome;
import org.palpate.frame.HapticFrame;

/**
 * Paces frames by absolute deadlines and measures them, without a thread of its own.
 *
 * <p>The deadlines form an even grid of one period. A late frame is counted, and the deadlines that
 * it missed are skipped: the next one is the first of the grid that is at least half a period away.
 * No burst of frames follows.
 *
 * <p>One thread runs it. Any thread may read what is atomic or volatile.
 */
final class PacedLoop {
  private final HapticFrame frame;
  private final LoopSettings settings;
  private final DurationRecorder period = new DurationRecorder();
  private final DurationRecorder lateness = new DurationRecorder();
  private final DurationRecorder work = new DurationRecorder();
  private final AtomicLong lateFrames = new AtomicLong();
  private final AtomicLong latenessNanos = new AtomicLong();
  private final AtomicLong firstStartNanos = new AtomicLong();
  private final AtomicLong lastStartNanos = new AtomicLong();
  private final AtomicLong frames = new AtomicLong();
  private final AtomicBoolean betweenFrames = new AtomicBoolean();
  private volatile boolean started;
  private volatile boolean stopRequested;

  PacedLoop(HapticFrame frame, LoopSettings settings) {
    this.frame = frame;
    this.settings = settings;
  }

  /** Requests that the loop stops after its frame. Any thread. */
  void requestStop() {
    stopRequested = true;
  }

  /** Runs frames until a stop is requested or the device is gone. Throws what a frame throws. */
  LoopEnd.Cause run() {
    NanoClock clock = settings.clock();
    long deadline = clock.nanoTime();
    while (!stopRequested) {
      settings.pacer().awaitUntil(deadline);
      long start = clock.nanoTime();
      recordStart(start, start - deadline);
      FrameOutcome outcome = frame.run(start);
      work.record(clock.nanoTime() - start);
      frames.lazySet(frames.getPlain() + 1);
      if (outcome == FrameOutcome.DEVICE_GONE) {
        return LoopEnd.Cause.DEVICE_GONE;
      }
      betweenFrames.lazySet(true);
      deadline = nextDeadline(deadline, start);
    }
    return LoopEnd.Cause.STOPPED;
  }

  private void recordStart(long start, long lateNanos) {
    if (started) {
      period.record(start - lastStartNanos.getPlain());
      lastStartNanos.lazySet(start);
    } else {
      firstStartNanos.set(start);
      lastStartNanos.set(start);
      started = true;
    }
    lateness.record(lateNanos);
    latenessNanos.lazySet(Math.max(0, lateNanos));
    if (lateNanos > settings.periodNanos() / 2) {
      lateFrames.lazySet(lateFrames.getPlain() + 1);
    }
    betweenFrames.lazySet(false); // Last: whoever reads it also reads when the frame started.
  }

  private long nextDeadline(long deadline, long start) {
    long periodNanos = settings.periodNanos();
    long late = start - deadline;
    if (late < -periodNanos) {
      return start + periodNanos; // The clock was set back, so the old grid is void.
    }
    long missed = late > periodNanos / 2 ? (late + periodNanos / 2) / periodNanos : 0;
    return deadline + (missed + 1) * periodNanos;
  }

  /** Whether the first frame has started. Any thread. */
  boolean hasStarted() {
    return started;
  }

  /** Whether a frame has returned and another is to follow that has not started. Any thread. */
  boolean isBetweenFrames() {
    return betweenFrames.get();
  }

  /** Returns the time at which the last frame started. Any thread. */
  long lastStartNanos() {
    return lastStartNanos.get();
  }

  /** Returns the present status. Any thread. */
  LoopStatus status() {
    return new LoopStatus(
        frame.frameCount(),
        lateFrames.get(),
        latenessNanos.get(),
        frame.inContact(),
        frame.forceLengthNewton());
  }

  /** Returns the measurements so far. Any thread but the haptic one. */
  LoopReport report(ThreadSetup.Granted granted) {
    double seconds = (lastStartNanos.get() - firstStartNanos.get()) * 1e-9;
    long count = frames.get();
    return new LoopReport(
        seconds,
        seconds > 0 ? (count - 1) / seconds : 0,
        count,
        lateFrames.get(),
        period.quantiles(),
        lateness.quantiles(),
        work.quantiles(),
        granted,
        frame.statistics());
  }
}
