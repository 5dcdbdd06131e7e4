package org.palpate.imagej;

/**
 * An image, or what was asked of it, that cannot be touched; the message is for the user, in plain
 * words.
 */
final class StackRefused extends Exception {
  private static final long serialVersionUID = 1;

  StackRefused(String message) {
    super(message);
  }
}
