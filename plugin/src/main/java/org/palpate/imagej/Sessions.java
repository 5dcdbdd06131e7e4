package org.palpate.imagej;

import java.util.concurrent.atomic.AtomicReference;

/** The one session that runs in this ImageJ: there is one hand. Any thread. */
final class Sessions {
  /** The longest that a device takes to be sent zero force. */
  private static final long PATIENCE_MILLIS = 10_000;

  /** A window that is just being opened is waited for, and has nothing to do with the force. */
  private static final long WINDOW_MILLIS = 60_000;

  private static final AtomicReference<TouchRun> CURRENT = new AtomicReference<>();

  private Sessions() {}

  /**
   * Enters a session.
   *
   * @throws StackRefused where another one runs
   */
  static void begin(TouchRun run) throws StackRefused {
    if (!CURRENT.compareAndSet(null, run)) {
      throw busy();
    }
  }

  /**
   * Says before anything is set up what {@link #begin} would say.
   *
   * @throws StackRefused where a session runs
   */
  static void refuseSecond() throws StackRefused {
    if (isRunning()) {
      throw busy();
    }
  }

  private static StackRefused busy() {
    return new StackRefused("A volume is being touched already: press Escape to end that first.");
  }

  static boolean isRunning() {
    return CURRENT.get() != null;
  }

  static void end(TouchRun run) {
    CURRENT.compareAndSet(run, null);
  }

  /** Asks the session to end and waits for it; nothing where none runs. */
  static void stop() throws StackRefused {
    TouchRun run = CURRENT.get();
    if (run == null) {
      return;
    }
    run.session().askToStop();
    if (!run.session().awaitForceOff(PATIENCE_MILLIS)) {
      throw new StackRefused("The session does not end: look at the device's cable and driver.");
    }
    if (!run.await(WINDOW_MILLIS)) {
      throw new StackRefused("The session has ended, but its 3-D window does not close.");
    }
  }

  /**
   * The session that runs.
   *
   * @throws StackRefused where none does
   */
  static StackSession current() throws StackRefused {
    TouchRun run = CURRENT.get();
    if (run == null) {
      throw new StackRefused(
          "No volume is being touched: begin by Plugins > Palpate > Touch Volume...");
    }
    return run.session();
  }
}
