package org.palpate.elastic;

import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;

/**
 * Updates an elastic body in a thread of its own, at most {@link #RATE_HZ} times a second.
 *
 * <p>The haptic thread never waits for it. If an update fails or does not return, the haptic thread
 * goes on with the last proved field, and {@link #trouble} says why no other comes.
 */
public final class ElasticThread implements AutoCloseable {
  /** The most updates in a second. */
  public static final int RATE_HZ = 30;

  private static final long PERIOD_NANOS = 1_000_000_000L / RATE_HZ;

  /** An update that takes longer than this has stalled. */
  static final long STALL_NANOS = 10_000_000_000L;

  /** The longest wait for the last update at the end. */
  private static final long END_MILLIS = 2000;

  private final Runnable update;
  private final LongSupplier nanoClock;
  private final CountDownLatch ending = new CountDownLatch(1);
  private final Thread thread = new Thread(this::run, "palpate-elastic");
  private volatile boolean updating;
  private volatile long begunNanos;
  private volatile Throwable failure;

  /**
   * Creates a thread that has not started.
   *
   * @param body belongs to the haptic thread and to this one; no other updates it
   */
  public ElasticThread(ElasticBody body) {
    this(body.liveUpdate(), System::nanoTime);
  }

  /**
   * Creates a thread for any update.
   *
   * @param nanoClock the time since which an update runs
   */
  ElasticThread(Runnable update, LongSupplier nanoClock) {
    this.update = update;
    this.nanoClock = nanoClock;
    thread.setDaemon(true);
  }

  /** Starts the thread. Call it once. */
  public void start() {
    thread.start();
  }

  private void run() {
    try {
      long next = System.nanoTime();
      boolean ended = false;
      while (!ended) {
        begunNanos = nanoClock.getAsLong();
        updating = true;
        update.run();
        updating = false;
        next = Math.max(next + PERIOD_NANOS, System.nanoTime());
        ended = ending.await(next - System.nanoTime(), TimeUnit.NANOSECONDS);
      }
    } catch (Throwable thrown) {
      failure = thrown;
    }
  }

  /** {@return why no update comes; empty while they come} Any thread. */
  public Optional<String> trouble() {
    Throwable thrown = failure;
    if (thrown != null) {
      return Optional.of("an update failed (" + thrown + ")");
    }
    return updating && nanoClock.getAsLong() - begunNanos > STALL_NANOS
        ? Optional.of("an update has not returned for 10 s")
        : Optional.empty();
  }

  /** {@return what an update threw, if one failed} Any thread. */
  public Optional<Throwable> failure() {
    return Optional.ofNullable(failure);
  }

  /**
   * Ends the thread and waits for its last update, but not for one that has stalled. A second call
   * does no harm.
   */
  @Override
  public void close() {
    ending.countDown();
    boolean interrupted = false;
    try {
      thread.join(END_MILLIS);
    } catch (InterruptedException e) {
      interrupted = true;
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
