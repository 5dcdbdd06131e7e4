package org.palpate.force;

import org.palpate.geometry.Vec3;

/**
 * Limits the rate of the coupling force to the motion of the hand.
 *
 * <p>The interaction point may jump, for example from the surface to the voxels in a slit, or over
 * a rim. The hand feels such a jump as a push that builds up. In one frame the force changes by at
 * most {@link #STIFFNESS_FACTOR} k times the device's motion. A motion shorter than {@link
 * ChangeBound#MIN_MOTION_EDGES} counts as that long, so the force reaches its target even if the
 * device rests.
 *
 * <p>Haptic thread; allocates nothing.
 */
final class ForceRateLimit {
  static final double STIFFNESS_FACTOR = 1.5;

  private final double minMotionMm;
  private double framePart = 1;
  private final Vec3 lastForceNewton = new Vec3();
  private boolean begun;

  ForceRateLimit(double shortestEdgeMm) {
    minMotionMm = ChangeBound.MIN_MOTION_EDGES * shortestEdgeMm;
  }

  /** Lets the next force pass unlimited. */
  void reset() {
    begun = false;
  }

  /** Begins a frame: its part of the least motion counts. */
  void advance(long elapsedNanos) {
    framePart = FramePart.ofNanos(elapsedNanos);
  }

  /**
   * Limits the change of {@code forceNewton} in place.
   *
   * @param motionMm motion of the device since the last frame
   */
  void limit(Vec3 forceNewton, double stiffnessNewtonPerMm, double motionMm) {
    if (begun) {
      double stiffness = STIFFNESS_FACTOR * stiffnessNewtonPerMm;
      double maxChange = ChangeBound.ofMotion(stiffness, motionMm, framePart * minMotionMm);
      ChangeBound.apply(lastForceNewton, maxChange, forceNewton);
    }
    begun = true;
    lastForceNewton.set(forceNewton);
  }
}
