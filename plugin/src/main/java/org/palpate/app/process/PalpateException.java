package org.palpate.app.process;

/** What a person can mend, told in one line: what, where, what to do. */
public final class PalpateException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** Failed at run time. */
  public static final int FAILED = 1;

  /** Wrong use or bad input. */
  public static final int WRONG_USE = 2;

  private final int exitCode;

  private PalpateException(int exitCode, String line, Throwable cause) {
    super(line, cause);
    this.exitCode = exitCode;
  }

  /** Wrong use or bad input: exit code 2. */
  public static PalpateException wrongUse(String what, String where, String remedy) {
    return new PalpateException(WRONG_USE, line(what, where, remedy), null);
  }

  /** Wrong use or bad input that was noticed by {@code cause}: exit code 2. */
  public static PalpateException wrongUse(
      String what, String where, String remedy, Throwable cause) {
    return wrongUse(line(what, where, remedy), cause);
  }

  /** Wrong use or bad input, with a line that is whole already: exit code 2. */
  public static PalpateException wrongUse(String line, Throwable cause) {
    return new PalpateException(WRONG_USE, line, cause);
  }

  /** Failed at run time: exit code 1. */
  public static PalpateException failed(String what, String where, String remedy, Throwable cause) {
    return new PalpateException(FAILED, line(what, where, remedy), cause);
  }

  /** Failed at run time, with a line that is whole already: exit code 1. */
  public static PalpateException failed(String line, Throwable cause) {
    return new PalpateException(FAILED, line, cause);
  }

  /** The exit code of the process, 1 or 2. */
  public int exitCode() {
    return exitCode;
  }

  private static String line(String what, String where, String remedy) {
    return what + ": " + where + ": " + remedy;
  }
}
