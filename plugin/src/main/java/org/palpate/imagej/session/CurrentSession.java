package org.palpate.imagej.session;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.palpate.imagej.stack.TouchRefusedException;

/** The one session that runs in this ImageJ, because there is one hand. Any thread. */
public final class CurrentSession {
  /** The longest time until zero force is sent. */
  private static final long ZERO_FORCE_WAIT_MILLIS = 10_000;

  /** The longest time until a window closes that is just opening; it does not affect the force. */
  private static final long WINDOW_WAIT_MILLIS = 60_000;

  private static final AtomicReference<StackSessionRunner> CURRENT = new AtomicReference<>();

  private CurrentSession() {}

  /**
   * Registers a session.
   *
   * @throws TouchRefusedException if another one runs
   */
  static void begin(StackSessionRunner run) throws TouchRefusedException {
    if (!CURRENT.compareAndSet(null, run)) {
      throw busy();
    }
  }

  /**
   * Checks that {@link #begin} would succeed, before anything is set up.
   *
   * @throws TouchRefusedException if a session runs
   */
  public static void requireNoneRunning() throws TouchRefusedException {
    if (isRunning()) {
      throw busy();
    }
  }

  private static TouchRefusedException busy() {
    return new TouchRefusedException(
        "A volume is already being touched: press Escape to end that session first.");
  }

  /** Whether a session runs. */
  public static boolean isRunning() {
    return CURRENT.get() != null;
  }

  /** Unregisters a session. */
  static void end(StackSessionRunner run) {
    CURRENT.compareAndSet(run, null);
  }

  /**
   * Ends the session and waits for it; does nothing if none runs.
   *
   * @throws TouchRefusedException if the session or its window does not end in time
   */
  public static void stop() throws TouchRefusedException {
    StackSessionRunner run = CURRENT.get();
    if (run == null) {
      return;
    }
    run.session().requestStop();
    if (!run.session().awaitZeroForce(ZERO_FORCE_WAIT_MILLIS)) {
      throw new TouchRefusedException(
          "The session does not end: check the device's cable and driver.");
    }
    if (!run.await(WINDOW_WAIT_MILLIS)) {
      throw new TouchRefusedException("The session has ended, but its 3-D window does not close.");
    }
  }

  /**
   * Returns the running session.
   *
   * @throws TouchRefusedException if none runs, or fragments are being placed
   */
  public static StackSession current() throws TouchRefusedException {
    return current(StackSession.class)
        .orElseThrow(
            () ->
                new TouchRefusedException(
                    "No volume is being touched: start with Plugins > Palpate > Touch Volume..."));
  }

  /**
   * Returns the session that places fragments.
   *
   * @throws TouchRefusedException if none runs
   */
  public static PlacingSession placing() throws TouchRefusedException {
    return current(PlacingSession.class)
        .orElseThrow(
            () ->
                new TouchRefusedException(
                    "No fragments are being placed: start with Plugins > Palpate > Place"
                        + " Fragments..."));
  }

  private static <T extends HandSession> Optional<T> current(Class<T> kind) {
    return Optional.ofNullable(CURRENT.get())
        .map(StackSessionRunner::session)
        .filter(kind::isInstance)
        .map(kind::cast);
  }
}
