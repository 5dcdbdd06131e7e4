package org.palpate.scene.surface;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;

/** How far the extraction of some bricks is. Any thread may ask, stop it or wait. */
public final class SurfaceJob {
  private final int count;
  private final Runnable whenDone;
  private final CountDownLatch left;
  private final AtomicInteger ended = new AtomicInteger();
  private final AtomicReference<Throwable> failure = new AtomicReference<>();
  private volatile boolean stopped;

  SurfaceJob(int count, Runnable whenDone) {
    this.count = count;
    this.whenDone = whenDone;
    left = new CountDownLatch(count);
  }

  /** Does one brick, unless stopped or failed before. */
  void run(Runnable work) {
    try {
      if (!stopped && failure.get() == null) {
        work.run();
      }
    } catch (RuntimeException | Error problem) {
      failure.compareAndSet(null, problem);
    } finally {
      end();
    }
  }

  private void end() {
    try {
      boolean isLast = ended.incrementAndGet() == count;
      if (isLast && !stopped && failure.get() == null) {
        whenDone.run();
      }
    } catch (RuntimeException | Error problem) {
      failure.compareAndSet(null, problem);
    } finally {
      left.countDown();
    }
  }

  /** The share of bricks done, 0 to 1. */
  public double progress() {
    return count == 0 ? 1 : 1 - (double) left.getCount() / count;
  }

  public boolean isDone() {
    return left.getCount() == 0;
  }

  /** Leaves out the bricks that are not yet begun. */
  public void stop() {
    stopped = true;
  }

  /**
   * Waits until every brick is done or left out.
   *
   * @throws TimeoutException where that takes longer than {@code timeoutMillis}
   * @throws IllegalStateException where a brick failed, with the cause
   */
  public void await(long timeoutMillis) throws InterruptedException, TimeoutException {
    if (!left.await(timeoutMillis, TimeUnit.MILLISECONDS)) {
      throw new TimeoutException(
          left.getCount() + " of " + count + " bricks not done after " + timeoutMillis + " ms");
    }
    if (failure.get() != null) {
      throw new IllegalStateException("a surface brick failed", failure.get());
    }
  }
}
