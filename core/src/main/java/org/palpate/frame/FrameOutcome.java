package org.palpate.frame;

/** How a frame ended. */
public enum FrameOutcome {
  /** The session goes on. */
  RUNNING,
  /** The device is gone, or could not be written to for as long as a silence lasts. */
  DEVICE_GONE
}
