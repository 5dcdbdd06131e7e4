package org.palpate.force;

/**
 * A factor that climbs from 0 to 1, for a force that must not come at once: after the point was set
 * free, after a silence of the device, at the start of a session. Haptic thread.
 */
public final class ForceRamp {
  /** How long a force takes to come back. */
  public static final long DEFAULT_NANOS = 200_000_000;

  private final long durationNanos;
  private long passedNanos;

  /** A ramp at its top. {@code durationNanos} of 0 switches it off. */
  public ForceRamp(long durationNanos) {
    if (durationNanos < 0) {
      throw new IllegalArgumentException(
          "durationNanos must not be negative: durationNanos=" + durationNanos);
    }
    this.durationNanos = durationNanos;
    passedNanos = durationNanos;
  }

  /** Goes back to the foot: the factor is 0 until time passes. */
  public void start() {
    passedNanos = 0;
  }

  public boolean isAtTop() {
    return passedNanos >= durationNanos;
  }

  /** Lets time pass; negative time does nothing. */
  public void advance(long elapsedNanos) {
    if (elapsedNanos > 0 && !isAtTop()) {
      passedNanos = Math.min(durationNanos, passedNanos + Math.min(elapsedNanos, durationNanos));
    }
  }

  /** From 0 at the foot to 1 at the top. */
  public double factor() {
    return isAtTop() ? 1 : (double) passedNanos / durationNanos;
  }
}
