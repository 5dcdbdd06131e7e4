package org.palpate.loop;

/**
 * The end of a session's loop.
 *
 * @param cause why the loop ended
 * @param failure the throwable of {@link Cause#FAILED}; else null
 */
public record LoopEnd(Cause cause, Throwable failure) {
  /** The cause of an end. */
  public enum Cause {
    /** The caller stopped the loop. */
    STOPPED,
    /** The device went away, or its recording ended. */
    DEVICE_GONE,
    /** A frame, the thread's set-up or the warm-up threw. */
    FAILED,
    /**
     * A frame did not return, or no frame followed one that left a force. The loop closed the
     * device.
     */
    HUNG
  }

  /** {@return whether the last frame was whole: nothing failed in it, and it came in time} */
  public boolean isInOrder() {
    return cause == Cause.STOPPED || cause == Cause.DEVICE_GONE;
  }
}
