package org.palpate.loop;

import java.util.Arrays;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.LongConsumer;

/**
 * Repeats a frame until its time is steady, so that a session's first frames run compiled code. One
 * thread uses an instance, once.
 *
 * <p>The time is steady if two things hold: the medians of four batches of 500 frames differ by at
 * most a quarter of the least, and the JVM's second compiler has nothing left to do. The medians
 * alone say little. Frames of code of the first compiler have a steady time too, and a large method
 * waits longer for the second one than thousands of frames take.
 *
 * <p>The thread rests between two batches. A haptic thread of a real-time class would otherwise
 * keep a processor from the compiler that it waits for. While others prepare the session too, it
 * rests for half of the time, so that they have a processor beside the compiler.
 */
public final class SteadyWarmUp {
  private static final int FRAMES_A_BATCH = 500;
  private static final int STEADY_BATCHES = 4;

  /** The medians may differ by the least of them divided by this. */
  private static final int STEADY_DIVISOR = 4;

  /** Medians may always differ by this, because the clock has steps. */
  private static final long CLOCK_STEP_NANOS = 60;

  /** The rest after a batch, unless others need a longer one. */
  private static final long REST_NANOS = 1_000_000;

  /** The time between two questions to the compiler, which stop the JVM for a moment. */
  private static final long QUESTION_NANOS = 50_000_000;

  /** The idle answers in a row that are needed, because the frames between may give new work. */
  private static final int IDLE_ANSWERS = 2;

  private final NanoClock clock;
  private final BooleanSupplier compilerIsBusy;
  private final BooleanSupplier othersPrepare;
  private final LongConsumer rest;
  private final long[] times = new long[FRAMES_A_BATCH];
  private final long[] medians = new long[STEADY_BATCHES];
  private int batches;
  private long askedNanos;
  private int idleAnswers;

  /** Makes a warm-up that uses the machine's clock and the JVM's compiler. */
  public SteadyWarmUp() {
    this(NanoClock.SYSTEM);
  }

  /**
   * Makes a warm-up that uses the JVM's compiler.
   *
   * @param clock measures the frames
   */
  public SteadyWarmUp(NanoClock clock) {
    this(clock, () -> false);
  }

  /**
   * Makes a warm-up that uses the JVM's compiler and leaves time to others.
   *
   * @param clock measures the frames
   * @param othersPrepare whether other threads still prepare the session; asked by the thread that
   *     warms up
   */
  SteadyWarmUp(NanoClock clock, BooleanSupplier othersPrepare) {
    this(clock, new SecondCompiler(), othersPrepare, LockSupport::parkNanos);
  }

  SteadyWarmUp(
      NanoClock clock,
      BooleanSupplier compilerIsBusy,
      BooleanSupplier othersPrepare,
      LongConsumer rest) {
    this.clock = clock;
    this.compilerIsBusy = compilerIsBusy;
    this.othersPrepare = othersPrepare;
    this.rest = rest;
  }

  /**
   * Runs the frame in the calling thread until its time is steady or the limit is reached. If the
   * thread is interrupted, it stops after the present batch; the thread stays interrupted.
   *
   * @param frame one frame
   * @param minFrames the least number of frames, because frames differ in what they do
   * @param limitNanos the longest time; a batch that has begun is completed
   * @return whether the time is steady, and how many frames ran
   */
  public Result run(Runnable frame, int minFrames, long limitNanos) {
    long start = clock.nanoTime();
    askedNanos = start;
    boolean steady = false;
    while (!steady
        && clock.nanoTime() - start < limitNanos
        && !Thread.currentThread().isInterrupted()) {
      long begunNanos = clock.nanoTime();
      medians[batches % STEADY_BATCHES] = medianOfBatch(frame);
      long workedNanos = clock.nanoTime() - begunNanos;
      batches++;
      askCompiler();
      steady = (long) batches * FRAMES_A_BATCH >= minFrames && isSteady();
      if (!steady) {
        rest.accept(othersPrepare.getAsBoolean() ? Math.max(workedNanos, REST_NANOS) : REST_NANOS);
      }
    }
    long frames = (long) batches * FRAMES_A_BATCH;
    return new Result(steady, frames, clock.nanoTime() - start, lastMedian());
  }

  /**
   * Runs a batch and returns the median time of a frame. It sorts its own array of longs, because
   * the haptic thread runs it and shall not allocate.
   */
  private long medianOfBatch(Runnable frame) {
    for (int i = 0; i < FRAMES_A_BATCH; i++) {
      long start = clock.nanoTime();
      frame.run();
      times[i] = clock.nanoTime() - start;
    }
    Arrays.sort(times);
    return times[FRAMES_A_BATCH / 2];
  }

  private void askCompiler() {
    long nowNanos = clock.nanoTime();
    if (nowNanos - askedNanos >= QUESTION_NANOS) {
      askedNanos = nowNanos;
      idleAnswers = compilerIsBusy.getAsBoolean() ? 0 : idleAnswers + 1;
    }
  }

  private boolean isSteady() {
    if (batches < STEADY_BATCHES || idleAnswers < IDLE_ANSWERS) {
      return false;
    }
    long least = Arrays.stream(medians).min().orElseThrow();
    long most = Arrays.stream(medians).max().orElseThrow();
    return most - least <= Math.max(least / STEADY_DIVISOR, CLOCK_STEP_NANOS);
  }

  private long lastMedian() {
    return batches == 0 ? 0 : medians[(batches - 1) % STEADY_BATCHES];
  }

  /**
   * The result of a warm-up.
   *
   * @param steady whether the time of a frame became steady before the limit
   * @param frames number of frames that ran
   * @param nanos duration of the warm-up
   * @param medianNanos median time of a frame in the last batch
   */
  public record Result(boolean steady, long frames, long nanos, long medianNanos) {}
}
