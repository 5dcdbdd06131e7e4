package org.palpate.force;

/**
 * A factor that rises from 0 to 1, so that a force returns gradually. A frame starts it after the
 * interaction point was set free and after a silence of the device. Haptic thread.
 */
public final class ForceRamp {
  /** The usual time in which a force returns. */
  public static final long DEFAULT_NANOS = 200_000_000;

  private final long durationNanos;
  private long elapsedNanos;

  /**
   * Makes a completed ramp, whose factor is 1.
   *
   * @param durationNanos time from 0 to 1; 0 for no ramp
   * @throws IllegalArgumentException if the time is negative
   */
  public ForceRamp(long durationNanos) {
    if (durationNanos < 0) {
      throw new IllegalArgumentException(
          "durationNanos must not be negative: durationNanos=" + durationNanos);
    }
    this.durationNanos = durationNanos;
    elapsedNanos = durationNanos;
  }

  /** Restarts the ramp: the factor is 0 until time passes. */
  public void start() {
    elapsedNanos = 0;
  }

  /**
   * Advances the ramp by the time that has passed; negative time changes nothing.
   *
   * @param nanos the time since the last call, ns
   */
  public void advance(long nanos) {
    if (nanos > 0 && !isComplete()) {
      elapsedNanos = Math.min(durationNanos, elapsedNanos + Math.min(nanos, durationNanos));
    }
  }

  /** {@return the present factor, from 0 to 1} */
  public double factor() {
    return isComplete() ? 1 : (double) elapsedNanos / durationNanos;
  }

  private boolean isComplete() {
    return elapsedNanos >= durationNanos;
  }
}
