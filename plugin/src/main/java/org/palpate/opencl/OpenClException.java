package org.palpate.opencl;

/** OpenCL, or the device that was asked for, cannot be used. The message says why. */
public final class OpenClException extends Exception {
  private static final long serialVersionUID = 1;

  private final boolean isWrongChoice;

  OpenClException(String message, boolean isWrongChoice, Throwable cause) {
    super(message, cause);
    this.isWrongChoice = isWrongChoice;
  }

  /** Whether there are devices, but none of those that were asked for can be used. */
  public boolean isWrongChoice() {
    return isWrongChoice;
  }
}
