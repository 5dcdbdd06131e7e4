package org.palpate.imagej.session;

import ij.IJ;
import java.util.Locale;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.palpate.geometry.Vec3;
import org.palpate.host.SessionView;
import org.palpate.host.TouchSession;
import org.palpate.imagej.stack.StackGeometry;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.loop.LoopEnd;
import org.palpate.loop.LoopStatus;

/**
 * A live session on a stack, until the user presses Escape or calls "Stop Touching", the time or
 * the device ends, or the image or the 3-D window closes.
 *
 * <p>The session's own thread calls {@link #run}. Other threads may meanwhile call {@link
 * #touchedPointGrid} and {@link #requestStop}.
 */
public abstract class HandSession implements AutoCloseable {
  private static final long STATUS_NANOS = 500_000_000;
  private static final long FORCE_WAIT_SECONDS = 60;
  private static final double NANOS_PER_SECOND = 1e9;

  private final StackGeometry geometry;
  private final double seconds;
  private final Queue<ViewKeys.Action> actions = new ConcurrentLinkedQueue<>();
  private final CountDownLatch forceOn = new CountDownLatch(1);
  private final CountDownLatch forceOff = new CountDownLatch(1);
  private final Vec3 latestPoint = new Vec3();
  private volatile Vec3 pointGrid = new Vec3(Double.NaN, Double.NaN, Double.NaN);
  private volatile boolean stopRequested;
  private volatile Thread runner;

  /**
   * Creates a session that does not run yet.
   *
   * @param seconds its length, s; 0 for one without an end
   */
  HandSession(StackGeometry geometry, double seconds) {
    this.geometry = geometry;
    this.seconds = seconds;
  }

  /** Returns the session behind this one. */
  abstract TouchSession session();

  /** Returns the 3-D view, if there is one. */
  public abstract Optional<SessionView> view();

  /** Does what is due some thirty times a second. On the session's own thread. */
  abstract void tick() throws TouchRefusedException;

  /** Whether the image was closed. */
  abstract boolean isImageClosed();

  /** Does what follows an orderly end, after zero force was sent. On the session's own thread. */
  void finish() throws TouchRefusedException {}

  /**
   * Runs the session until it ends and zero force was sent. On the session's own thread.
   *
   * @throws TouchRefusedException if the size or type of the stack changed; the session has ended
   *     then
   */
  LoopEnd run() throws TouchRefusedException {
    IJ.resetEscape();
    session().start();
    view().ifPresent(SessionView::start);
    try {
      superviseUntilEnd();
    } finally {
      forceOn.countDown();
      session().stop();
      forceOff.countDown();
    }
    return session().stop();
  }

  private void superviseUntilEnd() throws TouchRefusedException {
    runner = Thread.currentThread();
    long startNanos = 0;
    long statusNanos = System.nanoTime();
    while (!session().supervise() && !isOver(startNanos)) {
      if (startNanos == 0 && session().status().frames() > 0) {
        startNanos = System.nanoTime();
      }
      if (startNanos != 0) {
        updatePoint();
      }
      runQueuedActions();
      tick();
      if (System.nanoTime() - statusNanos >= STATUS_NANOS) {
        statusNanos = System.nanoTime();
        showStatus();
      }
      LockSupport.parkNanos(this, TouchSession.SUPERVISION_PERIOD_NANOS);
    }
  }

  /** Wakes the session's thread before its next tick. Any thread. */
  void wake() {
    LockSupport.unpark(runner);
  }

  private boolean isOver(long startNanos) {
    boolean timeIsOver =
        seconds > 0
            && startNanos != 0
            && System.nanoTime() - startNanos >= seconds * NANOS_PER_SECOND;
    return timeIsOver || stopRequested || isImageClosed() || IJ.escapePressed();
  }

  private void updatePoint() {
    Vec3 now = view().map(SessionView::proxyGrid).orElseGet(this::takeUpdates);
    if (now.isFinite()) {
      pointGrid = now;
      forceOn.countDown();
    }
  }

  /** Takes what frames published, and returns the interaction point; a new vector. */
  Vec3 takeUpdates() {
    session().takeUpdates();
    return new Vec3().set(session().properties().touch().interactionPoint(latestPoint));
  }

  /** Queues an action for the session's thread. Any thread. */
  void queue(ViewKeys.Action action) {
    actions.add(action);
  }

  private void runQueuedActions() {
    for (ViewKeys.Action action = actions.poll(); action != null; action = actions.poll()) {
      try {
        action.run();
      } catch (TouchRefusedException e) {
        IJ.showStatus("Palpate: " + e.getMessage());
      }
    }
  }

  private void showStatus() {
    LoopStatus status = status();
    Vec3 at = geometry.gridToCalibrated(pointGrid, new Vec3());
    IJ.showStatus(
        String.format(
            Locale.ROOT,
            "Palpate: (%.2f, %.2f, %.2f) %s, %s, %.2f N; Escape ends",
            at.x,
            at.y,
            at.z,
            geometry.unit(),
            status.contact() ? "contact" : "free",
            status.forceNewton()));
  }

  /** Waits until the force is on or the session has ended. */
  void awaitForce() {
    try {
      if (!forceOn.await(FORCE_WAIT_SECONDS, TimeUnit.SECONDS)) {
        requestStop();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      requestStop();
    }
  }

  /** Waits until zero force was sent for good; returns whether it was. Any thread. */
  boolean awaitZeroForce(long millis) {
    try {
      return forceOff.await(millis, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  /** Requests the end of the session. Any thread. */
  void requestStop() {
    stopRequested = true;
    wake();
  }

  /**
   * Returns the interaction point in grid coordinates. Any thread.
   *
   * @throws TouchRefusedException before the first frame
   */
  public Vec3 touchedPointGrid() throws TouchRefusedException {
    Vec3 now = pointGrid;
    if (!now.isFinite()) {
      throw new TouchRefusedException("The first frame has not run yet: try again in a moment.");
    }
    return new Vec3().set(now);
  }

  /** Returns the present state of the haptic loop. Any thread. */
  public LoopStatus status() {
    return session().status();
  }

  @Override
  public void close() {
    view().ifPresent(SessionView::close);
    session().close();
    forceOff.countDown();
  }
}
