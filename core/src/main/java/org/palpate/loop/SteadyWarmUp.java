package org.palpate.loop;

import java.lang.management.CompilationMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.function.LongSupplier;

/**
 * Runs a frame over and over until its time is steady, so that the first touch does not run
 * interpreted code. One thread, once.
 *
 * <p>Steady: over four batches of 500 frames the median time of a frame stayed within a quarter of
 * the least of them, and the JVM compiled nothing new.
 */
public final class SteadyWarmUp {
  private static final int FRAMES_A_BATCH = 500;
  private static final int STEADY_BATCHES = 4;
  private static final int STEADY_SHARE = 4; // a quarter
  // Medians below this differ by the clock's own steps.
  private static final long CLOCK_STEP_NANOS = 60;

  private final NanoClock clock;
  private final LongSupplier compileMillis;
  private final long[] times = new long[FRAMES_A_BATCH];
  private final long[] medians = new long[STEADY_BATCHES];
  private int batches;
  private long compiledBefore;
  private int quietBatches;

  /** With the machine's clock and the JVM's compiler. */
  public SteadyWarmUp() {
    this(NanoClock.SYSTEM);
  }

  /** With the JVM's compiler. */
  public SteadyWarmUp(NanoClock clock) {
    this(clock, SteadyWarmUp::compilationMillis);
  }

  SteadyWarmUp(NanoClock clock, LongSupplier compileMillis) {
    this.clock = clock;
    this.compileMillis = compileMillis;
  }

  private static long compilationMillis() {
    CompilationMXBean compiler = ManagementFactory.getCompilationMXBean();
    return compiler != null && compiler.isCompilationTimeMonitoringSupported()
        ? compiler.getTotalCompilationTime()
        : 0;
  }

  /**
   * Runs the frame in the calling thread until it is steady or the time is up.
   *
   * @param frame one frame
   * @param leastFrames not before so many, since what a frame does varies from one to the next
   * @param limitNanos the most time to take; a batch that was begun is ended
   * @return what was found
   */
  public Result run(Runnable frame, int leastFrames, long limitNanos) {
    long began = clock.nanoTime();
    compiledBefore = compileMillis.getAsLong();
    boolean steady = false;
    while (!steady && clock.nanoTime() - began < limitNanos) {
      medians[batches % STEADY_BATCHES] = medianOfBatch(frame);
      batches++;
      noteCompiler();
      steady = (long) batches * FRAMES_A_BATCH >= leastFrames && isSteady();
    }
    long frames = (long) batches * FRAMES_A_BATCH;
    return new Result(steady, frames, clock.nanoTime() - began, lastMedian());
  }

  private long medianOfBatch(Runnable frame) {
    for (int i = 0; i < FRAMES_A_BATCH; i++) {
      long start = clock.nanoTime();
      frame.run();
      times[i] = clock.nanoTime() - start;
    }
    Arrays.sort(times);
    return times[FRAMES_A_BATCH / 2];
  }

  private void noteCompiler() {
    long compiled = compileMillis.getAsLong();
    quietBatches = compiled == compiledBefore ? quietBatches + 1 : 0;
    compiledBefore = compiled;
  }

  private boolean isSteady() {
    if (batches < STEADY_BATCHES || quietBatches < STEADY_BATCHES) {
      return false;
    }
    long least = Arrays.stream(medians).min().orElseThrow();
    long most = Arrays.stream(medians).max().orElseThrow();
    return most - least <= Math.max(least / STEADY_SHARE, CLOCK_STEP_NANOS);
  }

  private long lastMedian() {
    return batches == 0 ? 0 : medians[(batches - 1) % STEADY_BATCHES];
  }

  /**
   * How a warm-up ended.
   *
   * @param steady whether the frame's time became steady before the time was up
   * @param frames how many frames were run
   * @param nanos how long it took
   * @param medianNanos median time of a frame at the end
   */
  public record Result(boolean steady, long frames, long nanos, long medianNanos) {}
}
