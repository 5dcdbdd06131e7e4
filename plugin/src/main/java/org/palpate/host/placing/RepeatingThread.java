package org.palpate.host.placing;

import java.util.concurrent.locks.LockSupport;

/** Repeats work with a pause in between, on a daemon thread of its own, until it is closed. */
final class RepeatingThread implements AutoCloseable {
  private static final long JOIN_MILLIS = 1000;

  private final long pauseNanos;
  private final Runnable work;
  private final Runnable end;
  private final Thread thread;
  private volatile boolean closed;

  /**
   * Creates a thread that does not run yet.
   *
   * @param work what it repeats
   * @param end what it does last
   */
  RepeatingThread(String name, long pauseNanos, Runnable work, Runnable end) {
    this.pauseNanos = pauseNanos;
    this.work = work;
    this.end = end;
    thread = new Thread(this::run, name);
    thread.setDaemon(true);
  }

  void start() {
    thread.start();
  }

  private void run() {
    while (!closed) {
      work.run();
      LockSupport.parkNanos(this, pauseNanos);
    }
    end.run();
  }

  /** Ends the thread, and waits at most a second for work that is being done. */
  @Override
  public void close() {
    closed = true;
    LockSupport.unpark(thread);
    try {
      thread.join(JOIN_MILLIS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
