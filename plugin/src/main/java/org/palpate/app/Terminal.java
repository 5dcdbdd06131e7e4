package org.palpate.app;

/** Whether a person is looking. */
final class Terminal {
  /** Set by the launcher, which can tell; the JDK cannot tell for each stream. */
  private static final String PROPERTY = "palpate.terminal";

  private Terminal() {}

  /** Whether standard error goes to a terminal, as far as is known. */
  static boolean isThere() {
    return Boolean.getBoolean(PROPERTY);
  }
}
