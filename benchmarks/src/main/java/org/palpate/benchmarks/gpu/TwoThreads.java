package org.palpate.benchmarks.gpu;

import org.palpate.collision.LegBatch;
import org.palpate.collision.LegVerdict;

/**
 * Judges half of the legs on the caller's thread and half on a thread of its own. That thread spins
 * while it waits, because a spinning thread starts soonest.
 */
final class TwoThreads implements AutoCloseable {
  private final LegBatch first;
  private final LegBatch second;
  private final int half;
  private final Thread thread;
  private volatile long wanted;
  private volatile long done;
  private volatile boolean isClosed;
  private volatile long hitsOfSecond;

  /**
   * Starts the thread.
   *
   * @param first judges the caller's half of the points
   * @param second judges the other half
   * @param half the number of points in each half
   */
  TwoThreads(LegBatch first, LegBatch second, int half) {
    this.first = first;
    this.second = second;
    this.half = half;
    thread = new Thread(this::serve, "palpate-bench-legs");
    thread.setDaemon(true);
    thread.start();
  }

  private void serve() {
    while (!isClosed) {
      long number = wanted;
      if (number == done) {
        Thread.onSpinWait();
      } else {
        hitsOfSecond = hits(second, half);
        done = number;
      }
    }
  }

  /** Judges all legs and returns the number of hits. */
  long judge() {
    long number = wanted + 1;
    wanted = number;
    long hits = hits(first, half);
    while (done != number) {
      Thread.onSpinWait();
    }
    return hits + hitsOfSecond;
  }

  /** Judges legs on the calling thread and returns the number of hits. */
  static long hits(LegBatch batch, int points) {
    long hits = 0;
    for (int n = 0; n < points; n++) {
      hits += batch.verdict(0, n) == LegVerdict.HIT ? 1 : 0;
    }
    return hits;
  }

  @Override
  public void close() {
    isClosed = true;
  }
}
