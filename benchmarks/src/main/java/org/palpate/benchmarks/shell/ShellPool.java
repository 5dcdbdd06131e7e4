package org.palpate.benchmarks.shell;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;

/**
 * A fixed pool that shares out ranges of points: the caller is its first thread, the others wait,
 * spinning for a while before they park, so that the next frame finds them awake.
 *
 * <p>{@link #run} is for one thread, the haptic one; it takes no lock and allocates nothing. Cost:
 * about a microsecond a call besides the work; a thread that had parked takes as long as the
 * machine needs to wake it.
 */
public final class ShellPool implements AutoCloseable {
  /** A share of the work. */
  @FunctionalInterface
  public interface Share {
    /**
     * Works on some points.
     *
     * @param thread 0 for the caller, up to {@link #threads} less 1
     * @param from the first point
     * @param to one past the last
     * @return what is to be added up
     */
    int work(int thread, int from, int to);
  }

  /** Ranges begin at multiples of this, so that threads do not write to the same cache lines. */
  private static final int RANGE_STEP = 64;

  /** Some hundred microseconds: a frame at 1 kHz comes soon after the last one ended. */
  private static final int SPINS = 20_000;

  private static final int RESULT_STRIDE = 16; // ints of two cache lines

  private final Thread[] helpers;
  private final int[] results;
  private final AtomicInteger round = new AtomicInteger();
  private final AtomicInteger busy = new AtomicInteger();
  private final AtomicReference<Throwable> failure = new AtomicReference<>();
  private Share share;
  private int points;
  private volatile boolean closed;

  /** Starts {@code threads} less 1 daemon threads. */
  public ShellPool(int threads) {
    if (threads < 1) {
      throw new IllegalArgumentException("threads must be at least 1: threads=" + threads);
    }
    helpers = new Thread[threads - 1];
    results = new int[threads * RESULT_STRIDE];
    for (int helper = 0; helper < helpers.length; helper++) {
      int thread = helper + 1;
      helpers[helper] = new Thread(() -> help(thread), "palpate-shell-" + thread);
      helpers[helper].setDaemon(true);
      helpers[helper].start();
    }
  }

  /** The caller and those that help it. */
  public int threads() {
    return helpers.length + 1;
  }

  /**
   * Shares out points 0 to {@code count} less 1 and waits until all are done.
   *
   * @return the sum of what the shares returned
   * @throws IllegalStateException with what a helper threw as its cause, once all are done
   */
  public int run(int count, Share work) {
    share = work;
    points = count;
    failure.set(null); // of a round whose caller threw too, and so never asked
    busy.set(helpers.length);
    round.incrementAndGet(); // publishes the above to the helpers
    for (Thread helper : helpers) {
      LockSupport.unpark(helper);
    }
    try {
      results[0] = work.work(0, begin(0), begin(1));
    } finally {
      while (busy.get() > 0) {
        Thread.onSpinWait();
      }
    }
    return sum();
  }

  private int sum() {
    Throwable thrown = failure.get();
    if (thrown != null) {
      throw new IllegalStateException("a helper of the shell failed: " + thrown, thrown);
    }
    int sum = 0;
    for (int thread = 0; thread < threads(); thread++) {
      sum += results[thread * RESULT_STRIDE];
    }
    return sum;
  }

  private int begin(int thread) {
    if (thread == threads()) {
      return points;
    }
    return (int) ((long) points * thread / threads()) / RANGE_STEP * RANGE_STEP;
  }

  private void help(int thread) {
    int done = 0;
    while (awaitRoundAfter(done)) {
      done++;
      try {
        results[thread * RESULT_STRIDE] = share.work(thread, begin(thread), begin(thread + 1));
      } catch (Throwable t) { // whatever it is, the caller must hear of it and not wait for ever
        failure.set(t);
      }
      busy.decrementAndGet();
    }
  }

  private boolean awaitRoundAfter(int done) {
    for (int spins = 0; round.get() == done && !closed; spins++) {
      if (spins < SPINS) {
        Thread.onSpinWait();
      } else {
        LockSupport.park(this);
      }
    }
    return !closed;
  }

  /** Ends the helpers; not while {@link #run} runs. */
  @Override
  public void close() {
    closed = true;
    for (Thread helper : helpers) {
      LockSupport.unpark(helper);
    }
  }
}
