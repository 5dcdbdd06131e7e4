package org.palpate.imagej.stack;

/**
 * An image or a request that Palpate cannot serve. The message is for the user.
 *
 * <p>It is checked because every command must show it in a dialog; the command line has {@code
 * PalpateException} with an exit code instead.
 */
public final class TouchRefusedException extends Exception {
  private static final long serialVersionUID = 1;

  /** Creates a refusal with a full sentence for the user. */
  public TouchRefusedException(String message) {
    super(message);
  }
}
