package org.palpate.loop;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.palpate.frame.HapticFrame;

/**
 * Owns the haptic thread: sets it up, warms it up, waits for the device, paces the frames, and ends
 * with zero force.
 *
 * <pre>
 *   HapticLoop loop = new HapticLoop(frame, LoopSettings.ofRate(1000), end -> report(end));
 *   loop.start();
 *   loop.awaitEnd(10, TimeUnit.SECONDS);      // or do something else meanwhile
 *   LoopEnd end = loop.stop();
 *   LoopReport report = loop.report();
 * </pre>
 *
 * <p>However the loop ends, it last sends zero force, without the slew limit, if it can still reach
 * the device. It then calls the listener once, in the thread that caused the end. A throwable of
 * any kind ends the loop.
 *
 * <p>{@link #supervise} finds a haptic thread that stands still in a frame, or with a force on the
 * device. It closes the device, which by contract sends zero force. The session has then ended even
 * if the haptic thread never returns. Otherwise the device stays open, and whoever opened it closes
 * it.
 *
 * <p>The haptic thread runs {@link #run}. All other methods are for any other thread.
 */
public final class HapticLoop implements AutoCloseable {
  /** The name of the haptic thread. */
  public static final String THREAD_NAME = "palpate-haptic";

  /** The time between two questions to a device that is not ready. */
  private static final long READY_POLL_NANOS = 1_000_000;

  private static final int MAX_PREPARATION_WAITS = 10;

  private final HapticFrame frame;
  private final LoopSettings settings;
  private final PacedLoop pacedLoop;
  private final Consumer<LoopEnd> listener;
  private final AtomicReference<LoopEnd> end = new AtomicReference<>();
  private final CountDownLatch ended = new CountDownLatch(1);
  private final Thread thread = new Thread(this::run, THREAD_NAME);
  private final Object preparationLock = new Object();

  /** Holds the thread during {@link #prepare}, else null. Guarded by {@link #preparationLock}. */
  private Thread preparing;

  /** Says that no preparation may begin or go on. Guarded by {@link #preparationLock}. */
  private boolean preparationIsOver;

  private volatile ThreadSetup.Granted granted = ThreadSetup.Granted.NOTHING;

  // The supervising thread alone uses these.
  private boolean supervised;
  private long supervisedNanos;
  private long watchedSinceNanos;

  /**
   * Makes a loop that has not started.
   *
   * @param frame the work of each period; it belongs to the loop until the end
   * @param settings the period, the clock and the set-up of the thread
   * @param listener receives the end, once
   */
  public HapticLoop(HapticFrame frame, LoopSettings settings, Consumer<LoopEnd> listener) {
    this.frame = frame;
    this.settings = settings;
    this.listener = listener;
    pacedLoop = new PacedLoop(frame, settings);
    thread.setDaemon(true);
  }

  /** Starts the haptic thread. Call it once. */
  public void start() {
    thread.start();
  }

  /** Runs the whole session in the calling thread, instead of {@link #start}. */
  public void run() {
    LoopEnd.Cause cause = LoopEnd.Cause.FAILED;
    Throwable failure = null;
    try {
      granted = settings.threadSetup().setUp();
      prepare();
      cause = pacedLoop.run();
    } catch (Throwable thrown) {
      failure = thrown;
    }
    finish(cause, release(failure));
  }

  /**
   * Runs the warm-up and waits for the device. If {@link #stop} interrupts that, nothing after it
   * is interrupted.
   */
  private void prepare() {
    synchronized (preparationLock) {
      if (preparationIsOver) {
        return;
      }
      preparing = Thread.currentThread();
    }
    try {
      settings.warmUp().run();
      awaitDevice();
    } finally {
      synchronized (preparationLock) {
        preparing = null;
        if (preparationIsOver) {
          Thread.interrupted();
        }
      }
    }
  }

  /** Waits until the device is ready. No frame follows an interrupted wait. */
  private void awaitDevice() {
    while (!frame.device().isReady()) {
      LockSupport.parkNanos(this, READY_POLL_NANOS);
      if (Thread.currentThread().isInterrupted()) {
        pacedLoop.requestStop();
        return;
      }
    }
  }

  /** Interrupts a preparation that runs, and keeps one from beginning later. */
  private void endPreparation() {
    synchronized (preparationLock) {
      preparationIsOver = true;
      if (preparing != null) {
        preparing.interrupt();
      }
    }
  }

  /** Sends zero force and returns the failure so far, with that of sending added to it. */
  private Throwable release(Throwable failure) {
    if (end.get() != null) {
      return failure; // The loop ended by force, and the device is closed already.
    }
    try {
      frame.release();
    } catch (Throwable thrown) {
      return join(failure, thrown);
    }
    return failure;
  }

  private static Throwable join(Throwable first, Throwable second) {
    if (first == null) {
      return second;
    }
    if (first != second) {
      first.addSuppressed(second);
    }
    return first;
  }

  private void finish(LoopEnd.Cause cause, Throwable failure) {
    LoopEnd mine = new LoopEnd(failure != null ? LoopEnd.Cause.FAILED : cause, failure);
    boolean first = end.compareAndSet(null, mine);
    if (first) {
      try {
        listener.accept(mine);
      } finally {
        ended.countDown();
      }
    }
  }

  /**
   * Ends the session by force if no frame has started for longer than {@code hangNanos}. A haptic
   * thread may wait longer between two frames while the device has zero force and torque. Such a
   * wait, as on a machine that does not run the thread, leaves nothing to make safe. The next frame
   * finds the gap and starts from zero force.
   *
   * <p>One thread other than the haptic one calls it regularly, for example at 30 Hz. If the calls
   * themselves stopped for more than half of {@code hangNanos}, as in a suspended process, the wait
   * begins anew.
   *
   * @param nowNanos on the loop's clock
   * @return whether the session has ended
   */
  public boolean supervise(long nowNanos) {
    boolean stoodStill = nowNanos - supervisedNanos > settings.hangNanos() / 2;
    if (!supervised || stoodStill) {
      supervised = true;
      watchedSinceNanos = nowNanos;
    }
    supervisedNanos = nowNanos;
    boolean dangerous = isDangerous(); // Before the start, which is then that of this frame.
    long quietNanos = Math.min(nowNanos - watchedSinceNanos, nowNanos - pacedLoop.lastStartNanos());
    if (end.get() == null && dangerous && quietNanos > settings.hangNanos()) {
      endByForce();
    }
    return end.get() != null;
  }

  /** Whether a thread that stands still leaves a frame unfinished or a force on the device. */
  private boolean isDangerous() {
    return pacedLoop.hasStarted() && (!pacedLoop.isBetweenFrames() || frame.mayExertForce());
  }

  private void endByForce() {
    pacedLoop.requestStop();
    try {
      frame.device().close();
    } finally {
      finish(LoopEnd.Cause.HUNG, null);
      thread.interrupt();
    }
  }

  /**
   * Stops the loop after its present frame and waits for the end. A second call does no harm.
   *
   * <p>If the end does not come within {@code hangNanos}, the loop ends by force. A warm-up and a
   * wait for the device are interrupted and may take ten times as long.
   *
   * @return how the loop ended, now or before
   */
  public LoopEnd stop() {
    pacedLoop.requestStop();
    endPreparation();
    if (thread.getState() == Thread.State.NEW) {
      finish(LoopEnd.Cause.STOPPED, null);
    }
    long patienceNanos = settings.hangNanos() + settings.periodNanos();
    for (int waits = 1; !awaitEnd(patienceNanos, TimeUnit.NANOSECONDS); waits++) {
      if (pacedLoop.hasStarted() || waits == MAX_PREPARATION_WAITS) {
        endByForce();
      }
    }
    return end.get();
  }

  /**
   * Waits for the end.
   *
   * @param timeout the longest time to wait
   * @param unit the unit of the timeout
   * @return whether the loop has ended
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

  /** {@return how the loop ended, or null while it runs} */
  public LoopEnd end() {
    return end.get();
  }

  /** {@return the present status} */
  public LoopStatus status() {
    return pacedLoop.status();
  }

  /** {@return the measurements: complete after the end, before that accurate to about a frame} */
  public LoopReport report() {
    return pacedLoop.report(granted);
  }

  /** Stops the loop. */
  @Override
  public void close() {
    stop();
  }
}
