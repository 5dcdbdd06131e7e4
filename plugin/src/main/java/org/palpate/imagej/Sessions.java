package org.palpate.imagej;

import java.util.concurrent.atomic.AtomicReference;

/** The one session that runs in this ImageJ: there is one hand. Any thread. */
final class Sessions {
  private static final AtomicReference<StackSession> CURRENT = new AtomicReference<>();

  private Sessions() {}

  /**
   * Enters a session.
   *
   * @throws StackRefused where another one runs
   */
  static void begin(StackSession session) throws StackRefused {
    if (!CURRENT.compareAndSet(null, session)) {
      throw busy();
    }
  }

  /**
   * Says before anything is set up what {@link #begin} would say.
   *
   * @throws StackRefused where a session runs
   */
  static void refuseSecond() throws StackRefused {
    if (CURRENT.get() != null) {
      throw busy();
    }
  }

  private static StackRefused busy() {
    return new StackRefused("A volume is being touched already: press Escape to end that first.");
  }

  static void end(StackSession session) {
    CURRENT.compareAndSet(session, null);
  }

  /**
   * The session that runs.
   *
   * @throws StackRefused where none does
   */
  static StackSession current() throws StackRefused {
    StackSession session = CURRENT.get();
    if (session == null) {
      throw new StackRefused(
          "No volume is being touched: begin by Plugins > Palpate > Touch Volume...");
    }
    return session;
  }
}
