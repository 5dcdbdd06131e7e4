package org.palpate.benchmarks.sync;

import java.util.concurrent.Semaphore;

/** Draws on request on a thread of its own, requests in work making one more picture. */
final class DrawingThread implements AutoCloseable {
  private final Runnable draw;
  private final Semaphore wanted = new Semaphore(0);
  private final Thread thread = new Thread(this::run, "bench-draw");
  private volatile boolean closed;

  DrawingThread(Runnable draw) {
    this.draw = draw;
    thread.setDaemon(true);
  }

  void start() {
    thread.start();
  }

  /** Asks for a picture. Never waits. */
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

  /** Ends when the picture in work is done. */
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
