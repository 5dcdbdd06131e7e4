package org.palpate.imagej.session;

import java.util.concurrent.atomic.AtomicReference;
import org.palpate.imagej.stack.TouchRefusedException;

/** The one session that runs in this ImageJ: there is one hand. Any thread. */
public final class CurrentSession {
  /** The longest that a device takes to be sent zero force. */
  private static final long PATIENCE_MILLIS = 10_000;

  /** A window that is just being opened is waited for, and has nothing to do with the force. */
  private static final long WINDOW_MILLIS = 60_000;

  private static final AtomicReference<StackSessionRunner> CURRENT = new AtomicReference<>();

  private CurrentSession() {}

  /**
   * Enters a session.
   *
   * @throws TouchRefusedException where another one runs
   */
  static void begin(StackSessionRunner run) throws TouchRefusedException {
    if (!CURRENT.compareAndSet(null, run)) {
      throw busy();
    }
  }

  /**
   * Says before anything is set up what {@link #begin} would say.
   *
   * @throws TouchRefusedException where a session runs
   */
  public static void requireNoneRunning() throws TouchRefusedException {
    if (isRunning()) {
      throw busy();
    }
  }

  private static TouchRefusedException busy() {
    return new TouchRefusedException(
        "A volume is being touched already: press Escape to end that first.");
  }

  public static boolean isRunning() {
    return CURRENT.get() != null;
  }

  static void end(StackSessionRunner run) {
    CURRENT.compareAndSet(run, null);
  }

  /** Asks the session to end and waits for it; nothing where none runs. */
  public static void stop() throws TouchRefusedException {
    StackSessionRunner run = CURRENT.get();
    if (run == null) {
      return;
    }
    run.session().askToStop();
    if (!run.session().awaitZeroForce(PATIENCE_MILLIS)) {
      throw new TouchRefusedException(
          "The session does not end: look at the device's cable and driver.");
    }
    if (!run.await(WINDOW_MILLIS)) {
      throw new TouchRefusedException("The session has ended, but its 3-D window does not close.");
    }
  }

  /**
   * The session that runs.
   *
   * @throws TouchRefusedException where none does
   */
  public static StackSession current() throws TouchRefusedException {
    StackSessionRunner run = CURRENT.get();
    if (run == null) {
      throw new TouchRefusedException(
          "No volume is being touched: begin by Plugins > Palpate > Touch Volume...");
    }
    return run.session();
  }
}
