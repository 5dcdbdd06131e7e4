package org.palpate.device;

/** What a read of a device gave. */
public enum ReadStatus {
  /** A new sample. */
  FRESH,
  /** No sample newer than the last one. */
  REPEATED,
  /** The device is gone, or its recording has ended: nothing more will come. */
  DISCONNECTED
}
