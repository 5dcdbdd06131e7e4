package org.palpate.scene;

import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;

/**
 * Runs a tick 30 times a second on a thread of its own: it takes what the haptic thread published
 * and applies it to the scene.
 *
 * <p>Ticks keep to the clock: after a late tick the next one comes at its own time, and missed
 * ticks are skipped. The first exception of a tick is reported and the thread goes on, so that a
 * broken renderer does not end the session. Any thread starts and closes it.
 */
public final class SynchronizationThread implements AutoCloseable {
  /** The paper's rate. Source: Vlasov et al. 2013, section 5.2. */
  public static final double RATE_HZ = 30;

  /** Time between two ticks. */
  public static final long PERIOD_NANOS = Math.round(1e9 / RATE_HZ);

  /** The number of steps between two ticks. */
  private static final int STEPS = 4;

  private static final long JOIN_MILLIS = 1000;

  private final Runnable tick;
  private final Runnable step;
  private final Thread thread;
  private final AtomicLong ticks = new AtomicLong();
  private final Consumer<RuntimeException> onFailure;
  private volatile boolean closed;

  /** Used by the thread alone. */
  private boolean failed;

  private volatile long startedNanos;
  private volatile long lastNanos;

  /**
   * Creates a thread.
   *
   * @param tick runs at each tick
   * @param onFailure receives the first exception of a tick, on this thread
   */
  public SynchronizationThread(Runnable tick, Consumer<RuntimeException> onFailure) {
    this(tick, () -> {}, onFailure);
  }

  /**
   * Creates a thread that also runs a step four times in each period, for work that must begin
   * sooner than the next tick.
   *
   * @param tick runs at each tick
   * @param step runs four times in each period, the last time just before the tick
   * @param onFailure receives the first exception of a tick or a step, on this thread
   */
  public SynchronizationThread(Runnable tick, Runnable step, Consumer<RuntimeException> onFailure) {
    this.tick = tick;
    this.step = step;
    this.onFailure = onFailure;
    thread = new Thread(this::run, "palpate-sync");
    thread.setDaemon(true);
  }

  /** Starts the thread. Call it once. */
  public void start() {
    startedNanos = System.nanoTime();
    lastNanos = startedNanos;
    thread.start();
  }

  private void run() {
    long due = startedNanos;
    while (!closed) {
      due = Math.max(due + PERIOD_NANOS, System.nanoTime() - PERIOD_NANOS);
      for (int n = 1; n < STEPS; n++) {
        waitUntil(due - (STEPS - n) * PERIOD_NANOS / STEPS);
        runOnce(step);
      }
      waitUntil(due);
      runOnce(step);
      runOnce(tick);
      ticks.incrementAndGet();
      lastNanos = System.nanoTime();
    }
  }

  private void waitUntil(long nanos) {
    for (long remaining = nanos - System.nanoTime(); remaining > 0 && !closed; ) {
      LockSupport.parkNanos(this, remaining);
      remaining = nanos - System.nanoTime();
    }
  }

  private void runOnce(Runnable work) {
    try {
      work.run();
    } catch (RuntimeException e) {
      if (!failed) {
        failed = true;
        onFailure.accept(e);
      }
    }
  }

  /** Returns the rate of the ticks from the start to the last one, Hz; 0 before the first. */
  public double rateHz() {
    long nanos = lastNanos - startedNanos;
    return nanos > 0 ? ticks.get() * 1e9 / nanos : 0;
  }

  /** Stops the thread and waits at most a second for a hanging tick. */
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
