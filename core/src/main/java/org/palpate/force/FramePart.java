package org.palpate.force;

/**
 * Scales bounds that hold for a frame. They were chosen for frames of a millisecond; a shorter
 * frame gets its part of them, so that a bound for each second stays what it was.
 *
 * <p>A longer frame gets no more than one of a millisecond: the bounds keep a late frame from a
 * jump. Stateless.
 */
public final class FramePart {
  private static final double NANOS = 1e6;
  private static final double SECONDS = 1e-3;

  private FramePart() {}

  /**
   * {@return the part of a bound for a frame, in (0, 1]}
   *
   * @param elapsedNanos time since the last frame; 1 is returned if it is not positive, because
   *     then no time is known
   */
  public static double ofNanos(long elapsedNanos) {
    return elapsedNanos > 0 ? Math.min(1, elapsedNanos / NANOS) : 1;
  }

  /**
   * {@return the part of a bound for a frame, in (0, 1]}
   *
   * @param elapsedSeconds the time since the last frame, s; 0 or negative counts as a whole frame
   */
  public static double ofSeconds(double elapsedSeconds) {
    return elapsedSeconds > 0 ? Math.min(1, elapsedSeconds / SECONDS) : 1;
  }
}
