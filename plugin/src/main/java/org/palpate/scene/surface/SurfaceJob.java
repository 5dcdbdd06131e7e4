package org.palpate.scene.surface;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;

/** The extraction of some bricks. Any thread may ask for its progress or wait for it. */
public final class SurfaceJob {
  private final int count;
  private final Runnable whenDone;
  private final CountDownLatch remaining;
  private final AtomicInteger ended = new AtomicInteger();
  private final AtomicReference<Throwable> failure = new AtomicReference<>();

  SurfaceJob(int count, Runnable whenDone) {
    this.count = count;
    this.whenDone = whenDone;
    remaining = new CountDownLatch(count);
  }

  /** Extracts one brick, unless another one failed before. */
  void run(Runnable work) {
    try {
      if (failure.get() == null) {
        work.run();
      }
    } catch (RuntimeException | Error cause) {
      failure.compareAndSet(null, cause);
    } finally {
      end();
    }
  }

  /** Ends one brick that another job has extracted, or failed to extract. */
  void endLike(SurfaceJob other) {
    failure.compareAndSet(null, other.failure.get());
    end();
  }

  private void end() {
    try {
      boolean isLast = ended.incrementAndGet() == count;
      if (isLast && failure.get() == null) {
        whenDone.run();
      }
    } catch (RuntimeException | Error cause) {
      failure.compareAndSet(null, cause);
    } finally {
      remaining.countDown();
    }
  }

  /** Returns the fraction of finished bricks, 0 to 1. */
  public double progress() {
    return count == 0 ? 1 : 1 - (double) remaining.getCount() / count;
  }

  /** Whether every brick is finished. */
  public boolean isDone() {
    return remaining.getCount() == 0;
  }

  /**
   * Waits until every brick is finished.
   *
   * @throws TimeoutException if that takes longer than {@code timeoutMillis}
   * @throws IllegalStateException if a brick failed, with the cause
   */
  public void await(long timeoutMillis) throws InterruptedException, TimeoutException {
    if (!remaining.await(timeoutMillis, TimeUnit.MILLISECONDS)) {
      throw new TimeoutException(
          remaining.getCount()
              + " of "
              + count
              + " bricks not done after "
              + timeoutMillis
              + " ms");
    }
    if (failure.get() != null) {
      throw new IllegalStateException("a surface brick failed", failure.get());
    }
  }
}
