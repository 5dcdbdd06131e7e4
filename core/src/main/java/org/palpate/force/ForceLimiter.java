package org.palpate.force;

import org.palpate.geometry.Vec3;

/**
 * Keeps a force within what the device may be asked: finite or zero, no longer than the maximum
 * (its direction kept), no faster change than the slew. Haptic thread; allocates nothing.
 */
public final class ForceLimiter {
  /** The longest time for which slew is granted at once: a late frame must not buy a jump. */
  public static final double LONGEST_STEP_MS = 5;

  private static final double NANOS_PER_MS = 1e6;

  /** A vector that rounding left a hair too long becomes shorter than the maximum. */
  private static final double ROUNDING_SHARE = 1 - 0x1p-50;

  private final double maxForceNewton;
  private final double slewNewtonPerMs;
  private final Vec3 last = new Vec3();
  private long clamped;
  private long slewed;
  private long notFinite;

  /**
   * A limiter at rest.
   *
   * @param maxForceNewton the longest force, at least 0; infinity for no limit
   * @param slewNewtonPerMs the fastest change, positive; infinity for no limit
   */
  public ForceLimiter(double maxForceNewton, double slewNewtonPerMs) {
    if (!(maxForceNewton >= 0) || !(slewNewtonPerMs > 0)) {
      throw new IllegalArgumentException(
          "maximum must be at least 0 and slew positive: maxForceNewton="
              + maxForceNewton
              + " slewNewtonPerMs="
              + slewNewtonPerMs);
    }
    this.maxForceNewton = maxForceNewton;
    this.slewNewtonPerMs = slewNewtonPerMs;
  }

  /**
   * Limits {@code forceNewton} in place.
   *
   * @param elapsedNanos since the last call; granted as slew up to {@link #LONGEST_STEP_MS}
   */
  public void clamp(Vec3 forceNewton, long elapsedNanos) {
    if (!forceNewton.isFinite()) {
      forceNewton.set(0, 0, 0);
      notFinite++;
    }
    shortenToMaximum(forceNewton);
    if (slewNewtonPerMs < Double.POSITIVE_INFINITY) {
      slew(forceNewton, elapsedNanos);
    }
    last.set(forceNewton);
  }

  /** Forgets the last force: the next is slewed from zero. For forces cut off at once. */
  public void reset() {
    last.set(0, 0, 0);
  }

  /** Frames in which the maximum shortened the force. */
  public long clamped() {
    return clamped;
  }

  /** Frames in which the slew held the force back. */
  public long slewed() {
    return slewed;
  }

  /** Frames whose force was not finite and became zero. */
  public long notFinite() {
    return notFinite;
  }

  private void shortenToMaximum(Vec3 force) {
    if (maxForceNewton == Double.POSITIVE_INFINITY || force.length() <= maxForceNewton) {
      return;
    }
    clamped++;
    // Scaled by the largest component first, so that the length of a huge force does not overflow.
    double largest = Math.max(Math.abs(force.x), Math.max(Math.abs(force.y), Math.abs(force.z)));
    force.set(force.x / largest, force.y / largest, force.z / largest);
    force.mul(maxForceNewton / force.length(), force);
    if (force.length() > maxForceNewton) {
      force.mul(ROUNDING_SHARE, force);
    }
  }

  private void slew(Vec3 force, long elapsedNanos) {
    double ms = Math.min(Math.max(0, elapsedNanos / NANOS_PER_MS), LONGEST_STEP_MS);
    double most = slewNewtonPerMs * ms;
    double x = force.x - last.x;
    double y = force.y - last.y;
    double z = force.z - last.z;
    double change = Math.sqrt(x * x + y * y + z * z);
    if (change > most) {
      slewed++;
      double share = most / change;
      force.set(last.x + x * share, last.y + y * share, last.z + z * share);
      shortenToMaximum(force);
    }
  }
}
