package org.palpate.host;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * Runs a session's duties from its start to its end in a thread of its own, for platforms whose
 * commands are to return at once. Where the platform's process ends meanwhile, the session is asked
 * to stop and waited for, so that zero force is sent first.
 */
public final class SessionWorker {
  private static final long PATIENCE_MILLIS = 3000;

  private final CountDownLatch ended = new CountDownLatch(1);
  private final Runnable duties;
  private final Thread thread;
  private final Thread atExit;

  /**
   * A worker that has not started.
   *
   * @param duties the session, whole; what it throws reaches the thread's uncaught handler
   * @param stop asks the session to end; must not wait
   */
  public SessionWorker(Runnable duties, Runnable stop) {
    this.duties = duties;
    thread = new Thread(this::run, "palpate-session");
    thread.setDaemon(true);
    atExit =
        new Thread(
            () -> {
              stop.run();
              await(PATIENCE_MILLIS);
            },
            "palpate-end");
  }

  /** Starts; once. */
  public void start() {
    Runtime.getRuntime().addShutdownHook(atExit);
    thread.start();
  }

  private void run() {
    try {
      duties.run();
    } finally {
      ended.countDown();
      forgetExit();
    }
  }

  private void forgetExit() {
    try {
      Runtime.getRuntime().removeShutdownHook(atExit);
    } catch (IllegalStateException e) {
      // the process is ending, and the hook runs or has run
    }
  }

  /**
   * Whether the process is ending: windows are being taken down by others then, and nobody is there
   * to be told what they throw. Any thread.
   */
  public static boolean isProcessEnding() {
    Thread none = new Thread(() -> {});
    try {
      Runtime.getRuntime().addShutdownHook(none);
      Runtime.getRuntime().removeShutdownHook(none);
      return false;
    } catch (IllegalStateException e) {
      return true;
    }
  }

  /** Waits for the end; whether it came in that time. Any thread but the worker's own. */
  public boolean await(long millis) {
    try {
      return ended.await(millis, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }
}
