package org.palpate.app.process;

/** Whether a person is looking. */
public final class Terminal {
  /** Set by the launcher, which can tell; the JDK cannot tell for each stream. */
  private static final String PROPERTY = "palpate.terminal";

  private Terminal() {}

  /** Whether standard error goes to a terminal, as far as is known. */
  public static boolean isThere() {
    return Boolean.getBoolean(PROPERTY);
  }
}
