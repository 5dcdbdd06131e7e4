package org.palpate.device.protocol;

/** A capture cannot be read. The message names the line and the remedy. */
public final class CaptureFormatException extends Exception {
  private static final long serialVersionUID = 1;

  CaptureFormatException(int line, String what) {
    super("line " + line + ": " + what + ": capture the device again");
  }
}
