package org.palpate.benchmarks.shell;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;

/**
 * A fixed pool of threads that divides points into ranges. The caller is its first thread; the
 * others spin for a while before they park, so that they are awake for the next frame.
 *
 * <p>{@link #run} is for one thread, the haptic one; it takes no lock and allocates nothing. A call
 * costs about a microsecond besides the work; a parked thread takes as long as the machine needs to
 * wake it.
 */
public final class ShellPool implements AutoCloseable {
  /** The work on a range of points. */
  @FunctionalInterface
  public interface RangeTask {
    /**
     * Works on a range of points.
     *
     * @param thread 0 for the caller, up to {@link #threads} minus 1
     * @param from the first point
     * @param to one past the last point
     * @return a number to add to the sum
     */
    int work(int thread, int from, int to);
  }

  /** Ranges start at multiples of this, so that threads do not write to the same cache lines. */
  private static final int RANGE_STEP = 64;

  /** Lasts some hundred microseconds, because a frame at 1 kHz soon follows the last one. */
  private static final int SPINS = 20_000;

  private static final int RESULT_STRIDE = 16; // ints of two cache lines

  private final Thread[] workers;
  private final int[] results;
  private final AtomicInteger round = new AtomicInteger();
  private final AtomicInteger busy = new AtomicInteger();
  private final AtomicReference<Throwable> failure = new AtomicReference<>();
  private RangeTask task;
  private int points;
  private volatile boolean closed;

  /** Starts {@code threads} minus 1 daemon threads. */
  public ShellPool(int threads) {
    if (threads < 1) {
      throw new IllegalArgumentException("threads must be at least 1: threads=" + threads);
    }
    workers = new Thread[threads - 1];
    results = new int[threads * RESULT_STRIDE];
    for (int worker = 0; worker < workers.length; worker++) {
      int thread = worker + 1;
      workers[worker] = new Thread(() -> work(thread), "palpate-shell-" + thread);
      workers[worker].setDaemon(true);
      workers[worker].start();
    }
  }

  /** Returns the number of threads, the caller included. */
  public int threads() {
    return workers.length + 1;
  }

  /**
   * Divides points 0 to {@code count} minus 1 among the threads and waits until all are done.
   *
   * @return the sum of the results
   * @throws IllegalStateException with a worker's throwable as its cause, after all are done
   */
  public int run(int count, RangeTask work) {
    task = work;
    points = count;
    failure.set(null); // left by a round in which the caller threw too
    busy.set(workers.length);
    round.incrementAndGet(); // publishes the above to the workers
    for (Thread worker : workers) {
      LockSupport.unpark(worker);
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
      throw new IllegalStateException("a worker of the shell failed: " + thrown, thrown);
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

  private void work(int thread) {
    int done = 0;
    while (awaitRoundAfter(done)) {
      done++;
      try {
        results[thread * RESULT_STRIDE] = task.work(thread, begin(thread), begin(thread + 1));
      } catch (Throwable t) { // the caller must learn of any failure and not wait for ever
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

  /** Ends the workers; not to be called during {@link #run}. */
  @Override
  public void close() {
    closed = true;
    for (Thread worker : workers) {
      LockSupport.unpark(worker);
    }
  }
}
