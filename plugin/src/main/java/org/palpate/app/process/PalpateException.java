package org.palpate.app.process;

/**
 * An error that the user can correct, described in one line: what is wrong, where, and what to do.
 */
public final class PalpateException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** Exit code for failures at run time. */
  public static final int FAILED = 1;

  /** Exit code for wrong use or bad input. */
  public static final int WRONG_USE = 2;

  private final int exitCode;

  private PalpateException(int exitCode, String line, Throwable cause) {
    super(line, cause);
    this.exitCode = exitCode;
  }

  /** Returns an error of wrong use or bad input, exit code 2. */
  public static PalpateException wrongUse(String what, String where, String remedy) {
    return new PalpateException(WRONG_USE, line(what, where, remedy), null);
  }

  /** Returns an error of wrong use or bad input with its cause, exit code 2. */
  public static PalpateException wrongUse(
      String what, String where, String remedy, Throwable cause) {
    return wrongUse(line(what, where, remedy), cause);
  }

  /** Returns an error of wrong use or bad input with a complete line, exit code 2. */
  public static PalpateException wrongUse(String line, Throwable cause) {
    return new PalpateException(WRONG_USE, line, cause);
  }

  /** Returns a failure at run time, exit code 1. */
  public static PalpateException failed(String what, String where, String remedy, Throwable cause) {
    return new PalpateException(FAILED, line(what, where, remedy), cause);
  }

  /** Returns a failure at run time with a complete line, exit code 1. */
  public static PalpateException failed(String line, Throwable cause) {
    return new PalpateException(FAILED, line, cause);
  }

  /** Returns the exit code of the process, 1 or 2. */
  public int exitCode() {
    return exitCode;
  }

  private static String line(String what, String where, String remedy) {
    return what + ": " + where + ": " + remedy;
  }
}
