package org.palpate.app.command;

import java.io.PrintWriter;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.palpate.app.process.ShutdownHook;
import org.palpate.app.process.Terminal;
import org.palpate.host.SessionView;
import org.palpate.host.TouchSession;
import org.palpate.host.placing.FaceFitting;
import org.palpate.host.placing.LiveReadings;
import org.palpate.host.placing.SceneAutosave;
import org.palpate.loop.LoopEnd;
import org.palpate.loop.LoopStatus;

/**
 * Runs a session from start to end on the calling thread.
 *
 * <p>It supervises the session 30 times a second and prints its state once a second if a terminal
 * is attached. It stops the session when its time is over or the process must end.
 */
final class SessionSupervisor {
  private static final double NANOS_PER_SECOND = 1e9;

  private final TouchSession session;
  private final Optional<Double> limitSeconds;
  private final Runnable check;
  private final PrintWriter out;
  private final CountDownLatch stopRequested = new CountDownLatch(1);
  private final boolean onTerminal = Terminal.isInteractive();
  private Optional<SessionView> view = Optional.empty();
  private long startNanos;
  private long startMillis;
  private long endedNanos;
  private boolean troublePrinted;
  private boolean started;
  private long lastLineNanos;
  private long lastLineFrames;

  /**
   * Creates a supervisor.
   *
   * @param limitSeconds the longest time from force on; if empty, the session has no limit
   * @param check called at every tick, 30 times a second
   * @param out receives a line when the force is switched on
   */
  SessionSupervisor(
      TouchSession session, Optional<Double> limitSeconds, Runnable check, PrintWriter out) {
    this.check = check;
    this.session = session;
    this.limitSeconds = limitSeconds;
    this.out = out;
  }

  /** Requests the end of the session. Any thread, any number of times. */
  void stop() {
    stopRequested.countDown();
  }

  /** Shows the session in a window while it runs. Call it before {@link #run}. */
  void show(SessionView shown) {
    view = Optional.of(shown);
  }

  /** Runs the session as {@link #run()} does, with threads that read, guide and save it. */
  LoopEnd run(
      Optional<LiveReadings> readings,
      Optional<FaceFitting> fitting,
      Optional<SceneAutosave> autosave) {
    readings.ifPresent(LiveReadings::start);
    fitting.ifPresent(FaceFitting::start);
    autosave.ifPresent(SceneAutosave::start);
    try {
      return run();
    } finally {
      autosave.ifPresent(SceneAutosave::close);
      fitting.ifPresent(FaceFitting::close);
      readings.ifPresent(LiveReadings::close);
    }
  }

  /** Runs the session until it ends and zero force was sent; returns how it ended. */
  LoopEnd run() {
    ShutdownHook.endInOrder(stopRequested::countDown);
    try {
      session.start();
      view.ifPresent(SessionView::start);
      watch();
      LoopEnd end = session.stop();
      endedNanos = System.nanoTime();
      view.ifPresent(SessionView::close);
      session.takeUpdates();
      clearLine();
      return end;
    } finally {
      ShutdownHook.discardUnfinishedFiles();
    }
  }

  private void watch() {
    long next = System.nanoTime();
    boolean stop = false;
    while (!stop && !session.supervise() && !isOver()) {
      recordStart();
      takeUpdates();
      check.run();
      printTrouble();
      printProgress();
      next = Math.max(next + TouchSession.SUPERVISION_PERIOD_NANOS, System.nanoTime());
      stop = waitUntil(next);
    }
  }

  /** Prints once that elastic segments are no longer updated. */
  private void printTrouble() {
    Optional<String> trouble = session.elasticTrouble();
    if (trouble.isPresent() && !troublePrinted) {
      troublePrinted = true;
      clearLine();
      out.println(
          "palpate: "
              + trouble.get()
              + ": --elastic: the last shape stays; the session ends in 5 s if no update comes");
      out.flush();
    }
  }

  private boolean isOver() {
    return started
        && limitSeconds.isPresent()
        && System.nanoTime() - startNanos >= limitSeconds.get() * NANOS_PER_SECOND;
  }

  /** Waits until a time or the end of the session's time; returns whether the process must end. */
  private boolean waitUntil(long nanos) {
    long until = nanos;
    if (started && limitSeconds.isPresent()) {
      until = Math.min(nanos, startNanos + (long) (limitSeconds.get() * NANOS_PER_SECOND));
    }
    try {
      return stopRequested.await(until - System.nanoTime(), TimeUnit.NANOSECONDS);
    } catch (InterruptedException e) {
      return true; // whoever interrupts this thread ends the session with it
    }
  }

  private void recordStart() {
    if (!started && session.status().frames() > 0) {
      started = true;
      startNanos = System.nanoTime();
      startMillis = System.currentTimeMillis();
      lastLineNanos = startNanos;
      out.println("force is on; Ctrl-C ends the session");
      out.flush();
    }
  }

  private void takeUpdates() {
    if (started && view.isEmpty()) {
      session.takeUpdates();
    }
  }

  private void printProgress() {
    long now = System.nanoTime();
    if (!onTerminal || !started || now - lastLineNanos < NANOS_PER_SECOND) {
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
    if (onTerminal && started) {
      System.err.print("\r" + " ".repeat(60) + "\r");
    }
  }

  /** Returns when the force was switched on, ms since 1970; empty if it never was. */
  OptionalLong forceOnMillis() {
    return started ? OptionalLong.of(startMillis) : OptionalLong.empty();
  }

  /** Returns the time from force on to zero force, s. */
  double seconds() {
    return started ? (endedNanos - startNanos) / NANOS_PER_SECOND : 0;
  }
}
