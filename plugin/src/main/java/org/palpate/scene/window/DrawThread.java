package org.palpate.scene.window;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;

/**
 * Draws when asked and only then; requests that come while it draws make one more picture. When
 * drawing fails it says so once and ends; who asked is never disturbed. Any thread asks.
 */
final class DrawThread implements AutoCloseable {
  private static final long JOIN_MILLIS = 2000;

  private final Runnable draw;
  private final Consumer<Throwable> trouble;
  private final Thread thread;
  private final AtomicBoolean wanted = new AtomicBoolean();
  private final AtomicLong drawn = new AtomicLong();
  private volatile boolean closed;

  DrawThread(Runnable draw, Consumer<Throwable> trouble) {
    this.draw = draw;
    this.trouble = trouble;
    thread = new Thread(this::run, "palpate-draw");
    thread.setDaemon(true);
  }

  void start() {
    thread.start();
  }

  /** Asks for a picture. Never waits. */
  void request() {
    if (!wanted.getAndSet(true)) {
      LockSupport.unpark(thread);
    }
  }

  private void run() {
    try {
      while (!closed) {
        if (wanted.getAndSet(false)) {
          draw.run();
          drawn.incrementAndGet();
        } else {
          LockSupport.park(this);
        }
      }
    } catch (RuntimeException | Error e) {
      if (!closed) {
        trouble.accept(e);
      }
    }
  }

  long drawn() {
    return drawn.get();
  }

  /** Ends after the picture in work, and does not wait for that. */
  void abandon() {
    closed = true;
    LockSupport.unpark(thread);
  }

  /** Ends after the picture in work; does not wait long for one that hangs. */
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
