package org.palpate.device;

/** The result of reading a device. */
public enum ReadStatus {
  /** A new sample. */
  FRESH,
  /** No sample newer than the last one. */
  REPEATED,
  /** The device is gone, or its recording has ended. It delivers nothing more. */
  DISCONNECTED
}
