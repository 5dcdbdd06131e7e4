package org.palpate.loop;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.palpate.frame.HapticFrame;

/**
 * Owns the haptic thread: sets it up, warms it up, paces the frames, and ends with zero force.
 *
 * <pre>
 *   HapticLoop loop = new HapticLoop(frame, LoopSettings.ofRate(1000), end -> report(end));
 *   loop.start();
 *   loop.awaitEnd(10, TimeUnit.SECONDS);      // or go on with something else
 *   LoopEnd end = loop.stop();
 *   LoopReport report = loop.report();
 * </pre>
 *
 * <p>However it ends, zero force is the last that the device is sent where it can still be reached,
 * past the slew limit, and the listener hears of the end once, in the thread that brought it about.
 * A throwable of any kind ends it. A frame that does not come back is found by {@link #supervise}:
 * the device is then closed under it, which by contract sends zero force, and the session has ended
 * even if the thread never returns. Otherwise the device is left open: who opened it closes it.
 *
 * <p>Methods are for any thread but the haptic one, which runs {@link #run} alone.
 */
public final class HapticLoop implements AutoCloseable {
  /** The haptic thread's name. */
  public static final String THREAD_NAME = "palpate-haptic";

  private static final int MOST_WARM_UP_WAITS = 10;

  private final HapticFrame frame;
  private final LoopSettings settings;
  private final PacedLoop cycle;
  private final Consumer<LoopEnd> listener;
  private final AtomicReference<LoopEnd> end = new AtomicReference<>();
  private final CountDownLatch ended = new CountDownLatch(1);
  private final Thread thread = new Thread(this::run, THREAD_NAME);
  private volatile ThreadSetup.Granted granted = ThreadSetup.Granted.NOTHING;

  // Of the thread that supervises.
  private boolean supervised;
  private long supervisedNanos;
  private long watchedSinceNanos;

  /**
   * A loop that has not started.
   *
   * @param listener hears of the end, once
   */
  public HapticLoop(HapticFrame frame, LoopSettings settings, Consumer<LoopEnd> listener) {
    this.frame = frame;
    this.settings = settings;
    this.listener = listener;
    cycle = new PacedLoop(frame, settings);
    thread.setDaemon(true);
  }

  /** Starts the haptic thread. Once. */
  public void start() {
    thread.start();
  }

  /**
   * Runs the whole session in the thread that calls, instead of {@link #start}; returns at the end.
   */
  public void run() {
    LoopEnd.Cause cause = LoopEnd.Cause.FAILED;
    Throwable failure = null;
    try {
      granted = settings.threadSetup().setUp();
      settings.warmUp().run();
      cause = cycle.run();
    } catch (Throwable thrown) {
      failure = thrown;
    }
    finish(cause, release(failure));
  }

  /** Sends zero force; a failure to do so joins the first. */
  private Throwable release(Throwable failure) {
    if (end.get() != null) {
      return failure; // Ended by force: the device is closed already.
    }
    try {
      frame.release();
    } catch (Throwable thrown) {
      return joined(failure, thrown);
    }
    return failure;
  }

  private static Throwable joined(Throwable first, Throwable second) {
    if (first == null) {
      return second;
    }
    if (first != second) {
      first.addSuppressed(second);
    }
    return first;
  }

  private void finish(LoopEnd.Cause cause, Throwable failure) {
    LoopEnd.Cause found = failure != null ? LoopEnd.Cause.FAILED : cause;
    LoopEnd mine = new LoopEnd(found, failure);
    if (end.compareAndSet(null, mine)) {
      try {
        listener.accept(mine);
      } finally {
        ended.countDown();
      }
    }
  }

  /**
   * Ends the session by force where no frame has begun for longer than {@code hangNanos}. To be
   * called now and then, say at 30 Hz, by any one thread that is not the haptic one. Where that
   * thread too stood still, as in a process that was stopped, the loop is given its time again.
   *
   * @param nowNanos on the loop's clock
   * @return whether the session has ended, now or before
   */
  public boolean supervise(long nowNanos) {
    boolean stoodStill = nowNanos - supervisedNanos > settings.hangNanos() / 2;
    if (!supervised || stoodStill) {
      supervised = true;
      watchedSinceNanos = nowNanos;
    }
    supervisedNanos = nowNanos;
    long quietNanos = Math.min(nowNanos - watchedSinceNanos, nowNanos - cycle.lastBeganNanos());
    if (end.get() == null && cycle.hasBegun() && quietNanos > settings.hangNanos()) {
      endByForce();
    }
    return end.get() != null;
  }

  private void endByForce() {
    cycle.askToStop();
    try {
      frame.device().close();
    } finally {
      finish(LoopEnd.Cause.HUNG, null);
      thread.interrupt();
    }
  }

  /**
   * Asks the loop to end after its frame, waits for that, and ends it by force where it does not
   * come within {@code hangNanos}; a warm-up is given ten times that. Calling it again is harmless.
   *
   * @return how the loop ended, now or before
   */
  public LoopEnd stop() {
    cycle.askToStop();
    if (thread.getState() == Thread.State.NEW) {
      finish(LoopEnd.Cause.STOPPED, null);
    }
    long patienceNanos = settings.hangNanos() + settings.periodNanos();
    for (int waits = 1; !awaitEnd(patienceNanos, TimeUnit.NANOSECONDS); waits++) {
      if (cycle.hasBegun() || waits == MOST_WARM_UP_WAITS) {
        endByForce();
      }
    }
    return end.get();
  }

  /**
   * Waits for the end.
   *
   * @return whether it has come
   */
  public boolean awaitEnd(long timeout, TimeUnit unit) {
    long until = System.nanoTime() + unit.toNanos(timeout);
    boolean interrupted = false;
    try {
      while (true) {
        try {
          return ended.await(until - System.nanoTime(), TimeUnit.NANOSECONDS);
        } catch (InterruptedException e) {
          interrupted = true;
        }
      }
    } finally {
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  /** How the loop ended, or null while it runs. */
  public LoopEnd end() {
    return end.get();
  }

  /** A glance at the loop. */
  public LoopStatus status() {
    return cycle.status();
  }

  /** What was measured; whole once the loop has ended, else good to a frame or so. */
  public LoopReport report() {
    return cycle.report(granted);
  }

  /** Stops. */
  @Override
  public void close() {
    stop();
  }
}
