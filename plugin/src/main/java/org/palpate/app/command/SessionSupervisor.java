package org.palpate.app.command;

import java.io.PrintWriter;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.palpate.app.process.ShutdownHook;
import org.palpate.app.process.Terminal;
import org.palpate.host.SessionView;
import org.palpate.host.TouchSession;
import org.palpate.loop.LoopEnd;
import org.palpate.loop.LoopStatus;

/**
 * Watches a session from start to end in the thread that calls: supervises it some 30 times a
 * second, tells how it goes once a second on a terminal, and stops it when its time is over or the
 * process is asked to end.
 */
final class SessionSupervisor {
  private static final long TICK_NANOS = 33_333_333;
  private static final double NANOS_PER_SECOND = 1e9;

  private final TouchSession session;
  private final Optional<Double> limitSeconds;
  private final PrintWriter out;
  private final CountDownLatch stopAsked = new CountDownLatch(1);
  private final boolean onTerminal = Terminal.isThere();
  private Optional<SessionView> view = Optional.empty();
  private long beganNanos;
  private long endedNanos;
  private boolean began;
  private long lastLineNanos;
  private long lastLineFrames;

  /** Asks the session to end. Any thread, any number of times. */
  void stop() {
    stopAsked.countDown();
  }

  /** Shows the session in a window while it runs; before {@link #run}. */
  void show(SessionView shown) {
    view = Optional.of(shown);
  }

  SessionSupervisor(TouchSession session, Optional<Double> limitSeconds, PrintWriter out) {
    this.session = session;
    this.limitSeconds = limitSeconds;
    this.out = out;
  }

  /** Runs the session to its end, zero force sent, and says how it ended. */
  LoopEnd run() {
    ShutdownHook endOfProcess = ShutdownHook.asks(stopAsked::countDown);
    try {
      session.start();
      view.ifPresent(SessionView::start);
      watch();
      LoopEnd end = session.stop();
      endedNanos = System.nanoTime();
      view.ifPresent(SessionView::close);
      session.takeUnseen();
      clearLine();
      return end;
    } finally {
      endOfProcess.close();
    }
  }

  private void watch() {
    long next = System.nanoTime();
    boolean asked = false;
    while (!asked && !session.supervise() && !isOver()) {
      noteBeginning();
      takeUnseen();
      printProgress();
      next = Math.max(next + TICK_NANOS, System.nanoTime());
      asked = waitUntil(next);
    }
  }

  private boolean isOver() {
    return began
        && limitSeconds.isPresent()
        && System.nanoTime() - beganNanos >= limitSeconds.get() * NANOS_PER_SECOND;
  }

  /** Waits for a tick or the end of the time; true where the process is asked to end. */
  private boolean waitUntil(long nanos) {
    long until = nanos;
    if (began && limitSeconds.isPresent()) {
      until = Math.min(nanos, beganNanos + (long) (limitSeconds.get() * NANOS_PER_SECOND));
    }
    try {
      return stopAsked.await(until - System.nanoTime(), TimeUnit.NANOSECONDS);
    } catch (InterruptedException e) {
      return true; // someone wants this thread to end, and with it the session
    }
  }

  private void noteBeginning() {
    if (!began && session.status().frames() > 0) {
      began = true;
      beganNanos = System.nanoTime();
      lastLineNanos = beganNanos;
      out.println("force is on; Ctrl-C ends");
      out.flush();
    }
  }

  private void takeUnseen() {
    if (began && view.isEmpty()) {
      session.takeUnseen();
    }
  }

  private void printProgress() {
    long now = System.nanoTime();
    if (!onTerminal || !began || now - lastLineNanos < NANOS_PER_SECOND) {
      return;
    }
    LoopStatus status = session.status();
    double rate = (status.frames() - lastLineFrames) / ((now - lastLineNanos) / NANOS_PER_SECOND);
    System.err.print(
        String.format(
            Locale.ROOT,
            "\r%7.1f Hz, late %6.0f us, %s, %5.2f N ",
            rate,
            status.latestLatenessNanos() / 1e3,
            status.contact() ? "contact" : "free   ",
            status.forceNewton()));
    lastLineNanos = now;
    lastLineFrames = status.frames();
  }

  private void clearLine() {
    if (onTerminal && began) {
      System.err.print("\r" + " ".repeat(60) + "\r");
    }
  }

  /** How long the session was watched, from force on to zero force, s. */
  double seconds() {
    return began ? (endedNanos - beganNanos) / NANOS_PER_SECOND : 0;
  }
}
