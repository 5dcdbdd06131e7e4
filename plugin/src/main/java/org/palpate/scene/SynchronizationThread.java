package org.palpate.scene;

import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;

/**
 * Runs a tick some 30 times a second on a thread of its own: takes what the haptic thread published
 * and applies it to the scene.
 *
 * <p>Ticks keep to the clock: a late one is followed by the next at its own time, and ticks that
 * were missed wholly are left out, never made up for in a burst. What a tick throws is told, the
 * first time, and the thread goes on, so that a broken renderer does not end the session. Started
 * and closed by any thread.
 */
public final class SynchronizationThread implements AutoCloseable {
  /** The paper's rate. Source: Vlasov et al. 2013, section 5.2. */
  public static final double RATE_HZ = 30;

  private static final long PERIOD_NANOS = Math.round(1e9 / RATE_HZ);
  private static final long JOIN_MILLIS = 1000;

  private final Runnable tick;
  private final Thread thread;
  private final AtomicLong ticks = new AtomicLong();
  private final Consumer<RuntimeException> trouble;
  private volatile boolean closed;

  /** Touched by the thread alone. */
  private boolean failed;

  private volatile long startedNanos;
  private volatile long lastNanos;

  /**
   * A thread that has not started.
   *
   * @param trouble told of the first tick that throws; on this thread
   */
  public SynchronizationThread(Runnable tick, Consumer<RuntimeException> trouble) {
    this.tick = tick;
    this.trouble = trouble;
    thread = new Thread(this::run, "palpate-sync");
    thread.setDaemon(true);
  }

  /** Starts ticking. Once. */
  public void start() {
    startedNanos = System.nanoTime();
    lastNanos = startedNanos;
    thread.start();
  }

  private void run() {
    long due = startedNanos;
    while (!closed) {
      due = Math.max(due + PERIOD_NANOS, System.nanoTime() - PERIOD_NANOS);
      for (long left = due - System.nanoTime(); left > 0 && !closed; ) {
        LockSupport.parkNanos(this, left);
        left = due - System.nanoTime();
      }
      tickOnce();
    }
  }

  private void tickOnce() {
    try {
      tick.run();
    } catch (RuntimeException e) {
      if (!failed) {
        failed = true;
        trouble.accept(e);
      }
    }
    ticks.incrementAndGet();
    lastNanos = System.nanoTime();
  }

  /** Ticks so far. */
  public long ticks() {
    return ticks.get();
  }

  /** Ticks a second from start to the last one; 0 before the first. */
  public double rateHz() {
    long nanos = lastNanos - startedNanos;
    return nanos > 0 ? ticks.get() * 1e9 / nanos : 0;
  }

  /** Stops ticking and waits a second at most for a tick that hangs. */
  @Override
  public void close() {
    closed = true;
    LockSupport.unpark(thread);
    if (thread != Thread.currentThread()) {
      try {
        thread.join(JOIN_MILLIS);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
  }
}
