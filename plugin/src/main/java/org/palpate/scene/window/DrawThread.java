package org.palpate.scene.window;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;

/**
 * Draws on request only, on a thread of its own. Requests during a picture cause one more picture.
 *
 * <p>A failure of drawing is reported once and ends the thread; it never disturbs the requesting
 * thread. Any thread requests.
 */
final class DrawThread implements AutoCloseable {
  private static final long JOIN_MILLIS = 2000;

  private final Runnable draw;
  private final Consumer<Throwable> onFailure;
  private final Thread thread;
  private final AtomicBoolean requested = new AtomicBoolean();
  private final AtomicLong drawn = new AtomicLong();
  private volatile boolean closed;

  /**
   * Creates a thread.
   *
   * @param draw draws one picture, on this thread
   * @param onFailure receives what drawing threw, once, on this thread
   */
  DrawThread(Runnable draw, Consumer<Throwable> onFailure) {
    this.draw = draw;
    this.onFailure = onFailure;
    thread = new Thread(this::run, "palpate-draw");
    thread.setDaemon(true);
  }

  /** Starts the thread. Call it once. */
  void start() {
    thread.start();
  }

  /** Requests a picture. Never waits. */
  void request() {
    if (!requested.getAndSet(true)) {
      LockSupport.unpark(thread);
    }
  }

  private void run() {
    try {
      while (!closed) {
        if (requested.getAndSet(false)) {
          draw.run();
          drawn.incrementAndGet();
        } else {
          LockSupport.park(this);
        }
      }
    } catch (RuntimeException | Error e) {
      if (!closed) {
        onFailure.accept(e);
      }
    }
  }

  /** Returns the number of pictures drawn. */
  long drawn() {
    return drawn.get();
  }

  /** Ends the thread after the present picture, without waiting. */
  void abandon() {
    closed = true;
    LockSupport.unpark(thread);
  }

  /** Ends the thread after the present picture, and waits for a limited time. */
  @Override
  public void close() {
    abandon();
    if (Thread.currentThread() != thread) {
      try {
        thread.join(JOIN_MILLIS);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
  }
}
