package org.palpate.host;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * Runs a session in a thread of its own, for platforms whose commands must return at once.
 *
 * <p>If the process ends meanwhile, the worker asks the session to stop and waits, so that zero
 * force is sent first.
 */
public final class SessionWorker {
  private static final long SHUTDOWN_WAIT_MILLIS = 3000;

  private final CountDownLatch ended = new CountDownLatch(1);
  private final Runnable session;
  private final Thread thread;
  private final Thread shutdownHook;

  /**
   * Creates a worker.
   *
   * @param session runs the whole session; what it throws reaches the thread's uncaught handler
   * @param stop asks the session to end; must not wait
   */
  public SessionWorker(Runnable session, Runnable stop) {
    this.session = session;
    thread = new Thread(this::run, "palpate-session");
    thread.setDaemon(true);
    shutdownHook =
        new Thread(
            () -> {
              stop.run();
              await(SHUTDOWN_WAIT_MILLIS);
            },
            "palpate-end");
  }

  /** Starts the thread. Call it once. */
  public void start() {
    Runtime.getRuntime().addShutdownHook(shutdownHook);
    thread.start();
  }

  private void run() {
    try {
      session.run();
    } finally {
      ended.countDown();
      removeShutdownHook();
    }
  }

  private void removeShutdownHook() {
    try {
      Runtime.getRuntime().removeShutdownHook(shutdownHook);
    } catch (IllegalStateException e) {
      // The process is ending; the hook runs or has run.
    }
  }

  /**
   * {@return whether the process is ending} Others close the windows then, and nobody is left to
   * read a message. Any thread.
   */
  public static boolean isProcessEnding() {
    Thread probe = new Thread(() -> {});
    try {
      Runtime.getRuntime().addShutdownHook(probe);
      Runtime.getRuntime().removeShutdownHook(probe);
      return false;
    } catch (IllegalStateException e) {
      return true;
    }
  }

  /**
   * Waits for the end. Any thread but the worker's own.
   *
   * @param millis the longest time to wait, ms
   * @return whether the session ended in time
   */
  public boolean await(long millis) {
    try {
      return ended.await(millis, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }
}
