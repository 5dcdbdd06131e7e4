package org.palpate.app.process;

/** Finds out whether output goes to a terminal. */
public final class Terminal {
  /** The launcher sets this property; the JDK cannot examine each stream. */
  private static final String PROPERTY = "palpate.terminal";

  private Terminal() {}

  /** Whether standard error goes to a terminal, as far as is known. */
  public static boolean isInteractive() {
    return Boolean.getBoolean(PROPERTY);
  }
}
