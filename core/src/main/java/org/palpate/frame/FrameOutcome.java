package org.palpate.frame;

/** The outcome of a frame. */
public enum FrameOutcome {
  /** The session goes on. */
  RUNNING,
  /** The device is gone, or has not accepted a force for the time of a silence. */
  DEVICE_GONE
}
