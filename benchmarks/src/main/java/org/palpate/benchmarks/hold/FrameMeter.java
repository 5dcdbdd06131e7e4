package org.palpate.benchmarks.hold;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import org.palpate.frame.ToolFrame;
import org.palpate.loop.Pacer;

/**
 * Measures the frames of a session from where it waits for them. A frame lasts from the end of one
 * wait to the beginning of the next.
 *
 * <p>The haptic thread writes; it allocates nothing. Other threads read after the session.
 */
final class FrameMeter implements Pacer {
  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
  private static final double NANOS_PER_SECOND = 1e9;
  private static final double NANOS_PER_MICRO = 1e3;

  private final Pacer pacer;
  private final long[] startNanos;
  private final long[] lateNanos;
  private final long[] processorNanos;
  private final long[] work;
  private final boolean[] held;
  private final boolean[] touching;

  /** Set before the session starts. */
  private ToolFrame frame;

  private int count;
  private long framesBefore;
  private long deadlineNanos;
  private long begunNanos;
  private long processorBefore;

  /**
   * Creates a meter.
   *
   * @param pacer does the waiting
   * @param mostFrames the number of frames after which no more are noted
   */
  FrameMeter(Pacer pacer, int mostFrames) {
    this.pacer = pacer;
    startNanos = new long[mostFrames];
    lateNanos = new long[mostFrames];
    processorNanos = new long[mostFrames];
    work = new long[mostFrames];
    held = new boolean[mostFrames];
    touching = new boolean[mostFrames];
  }

  /** Sets the frame that the session runs. Call it before the session starts. */
  void measure(ToolFrame measured) {
    frame = measured;
  }

  @Override
  public void awaitUntil(long deadline) {
    long processor = THREADS.getCurrentThreadCpuTime();
    if (frame.frameCount() > framesBefore && count < startNanos.length) {
      note(processor - processorBefore);
    }
    pacer.awaitUntil(deadline);
    begunNanos = System.nanoTime();
    deadlineNanos = deadline;
    framesBefore = frame.frameCount();
    processorBefore = THREADS.getCurrentThreadCpuTime();
  }

  private void note(long processor) {
    startNanos[count] = begunNanos;
    lateNanos[count] = begunNanos - deadlineNanos;
    processorNanos[count] = processor;
    work[count] = frame.work();
    held[count] = frame.heldBody() >= 0;
    touching[count] = frame.inContact();
    count++;
  }

  /** Returns the frames from a time after the first one on. */
  Measured from(double seconds) {
    int first = 0;
    while (first < count && startNanos[first] - startNanos[0] < seconds * NANOS_PER_SECOND) {
      first++;
    }
    return new Measured(first);
  }

  /** The frames of the last part of a session. */
  final class Measured {
    private final int first;

    private Measured(int first) {
      this.first = first;
    }

    int frames() {
      return count - first;
    }

    /** Returns the time from the deadline of each frame to its beginning, us. */
    double[] lateMicros() {
      return micros(lateNanos);
    }

    /** Returns the processor time of the haptic thread in each frame, us. */
    double[] processorMicros() {
      return micros(processorNanos);
    }

    /** Returns what the solver counted in each frame: tested points and their equivalent. */
    double[] work() {
      return Arrays.stream(work, first, count).asDoubleStream().toArray();
    }

    /** Returns the part of the frames after which the hand held a body, 0 to 1. */
    double held() {
      return share(held);
    }

    /** Returns the part of the frames that ended in contact, 0 to 1. */
    double touching() {
      return share(touching);
    }

    private double[] micros(long[] nanos) {
      return Arrays.stream(nanos, first, count).mapToDouble(n -> n / NANOS_PER_MICRO).toArray();
    }

    private double share(boolean[] values) {
      int found = 0;
      for (int n = first; n < count; n++) {
        found += values[n] ? 1 : 0;
      }
      return (double) found / Math.max(1, frames());
    }
  }
}
