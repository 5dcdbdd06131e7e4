package org.palpate.imagej.stack;

/**
 * An image, or what was asked of it, that cannot be touched; the message is for the user, in plain
 * words.
 */
public final class TouchRefusedException extends Exception {
  private static final long serialVersionUID = 1;

  public TouchRefusedException(String message) {
    super(message);
  }
}
