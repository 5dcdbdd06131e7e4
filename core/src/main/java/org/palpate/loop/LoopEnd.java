package org.palpate.loop;

/**
 * How a session's loop ended.
 *
 * @param cause why
 * @param failure what was thrown, where {@code cause} is {@link Cause#FAILED}; else null
 */
public record LoopEnd(Cause cause, Throwable failure) {
  /** Why a loop ended. */
  public enum Cause {
    /** It was asked to. */
    STOPPED,
    /** The device went away, or its recording ended. */
    DEVICE_GONE,
    /** A frame, or what went before the first, threw. */
    FAILED,
    /** A frame did not come back; the device was closed under it. */
    HUNG
  }
}
