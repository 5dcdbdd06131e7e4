package org.palpate.app;

/** Whether a person is looking. */
final class Terminal {
  /** Set by the launcher, which can tell; later JDKs have a console even without a terminal. */
  private static final String PROPERTY = "palpate.terminal";

  private Terminal() {}

  /** Whether standard error goes to a terminal, as far as can be told. */
  static boolean isThere() {
    String told = System.getProperty(PROPERTY);
    boolean consoleTells = Runtime.version().feature() < 22;
    return told == null ? consoleTells && System.console() != null : Boolean.parseBoolean(told);
  }
}
