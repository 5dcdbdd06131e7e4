package org.palpate.device.jni;

/** A device could not be opened. The message is one line, {@code WHAT: WHERE: what to do}. */
public final class DeviceException extends Exception {
  private static final long serialVersionUID = 1;

  /** Creates an exception with a one-line message. */
  public DeviceException(String message) {
    super(message);
  }
}
