package org.palpate.benchmarks.sync;

import java.util.concurrent.Semaphore;

/** Draws on request in its own thread; all requests during a drawing cause one more picture. */
final class DrawingThread implements AutoCloseable {
  private final Runnable draw;
  private final Semaphore wanted = new Semaphore(0);
  private final Thread thread = new Thread(this::run, "bench-draw");
  private volatile boolean closed;

  /** Creates a thread that is not yet started. */
  DrawingThread(Runnable draw) {
    this.draw = draw;
    thread.setDaemon(true);
  }

  /** Starts the thread. */
  void start() {
    thread.start();
  }

  /** Requests a picture. Never waits. */
  void request() {
    wanted.release();
  }

  private void run() {
    while (!closed) {
      wanted.acquireUninterruptibly();
      wanted.drainPermits();
      if (!closed) {
        draw.run();
      }
    }
  }

  /** Ends the thread after its current picture. */
  @Override
  public void close() {
    closed = true;
    wanted.release();
    try {
      thread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
