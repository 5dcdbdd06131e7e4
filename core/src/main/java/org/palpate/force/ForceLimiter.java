package org.palpate.force;

import org.palpate.geometry.Vec3;

/**
 * Limits a force to the capabilities of the device; another instance limits the torque, in N mm
 * instead of N.
 *
 * <p>The result is finite or zero, no longer than the maximum, and changes no faster than the slew
 * rate. The maximum keeps the direction of the force. Haptic thread; allocates nothing.
 */
public final class ForceLimiter {
  /**
   * The longest step of time that the slew rate counts, ms. A late frame may not change the force
   * by a jump.
   */
  public static final double MAX_STEP_MS = 5;

  private static final double NANOS_PER_MS = 1e6;

  /** Makes a vector that rounding left slightly too long shorter than the maximum. */
  private static final double ROUNDING_FACTOR = 1 - 0x1p-50;

  private final double maxForceNewton;
  private final double slewNewtonPerMs;
  private final Vec3 lastForceNewton = new Vec3();
  private long notFinite;

  /**
   * Makes a limiter whose last force is zero.
   *
   * @param maxForceNewton the longest force, at least 0; infinity for no limit
   * @param slewNewtonPerMs the fastest change, positive; infinity for no limit
   * @throws IllegalArgumentException if the maximum is negative or the slew is not positive
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
   * Limits a force in place.
   *
   * @param forceNewton the force to limit, N; may be NaN or infinite
   * @param elapsedNanos time since the last call; counts up to {@link #MAX_STEP_MS}
   */
  public void clamp(Vec3 forceNewton, long elapsedNanos) {
    if (!forceNewton.isFinite()) {
      forceNewton.set(0, 0, 0);
      notFinite++;
    }
    limitLength(forceNewton);
    if (slewNewtonPerMs < Double.POSITIVE_INFINITY) {
      limitSlew(forceNewton, elapsedNanos);
    }
    lastForceNewton.set(forceNewton);
  }

  /** Restarts the slew from zero. Call it after a force was dropped at once. */
  public void reset() {
    lastForceNewton.set(0, 0, 0);
  }

  /** {@return the number of forces that were not finite and became zero} */
  public long notFinite() {
    return notFinite;
  }

  private void limitLength(Vec3 force) {
    if (maxForceNewton == Double.POSITIVE_INFINITY || force.length() <= maxForceNewton) {
      return;
    }
    // Divides by the largest component first, so that the length of a huge force is finite.
    double largest = Math.max(Math.abs(force.x), Math.max(Math.abs(force.y), Math.abs(force.z)));
    force.set(force.x / largest, force.y / largest, force.z / largest);
    force.mul(maxForceNewton / force.length(), force);
    if (force.length() > maxForceNewton) {
      force.mul(ROUNDING_FACTOR, force);
    }
  }

  private void limitSlew(Vec3 force, long elapsedNanos) {
    double ms = Math.min(Math.max(0, elapsedNanos / NANOS_PER_MS), MAX_STEP_MS);
    boolean slewed = ChangeBound.apply(lastForceNewton, slewNewtonPerMs * ms, force);
    if (slewed) {
      limitLength(force);
    }
  }
}
