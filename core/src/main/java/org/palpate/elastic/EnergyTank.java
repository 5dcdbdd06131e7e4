package org.palpate.elastic;

import org.palpate.geometry.Vec3;

/**
 * Keeps elastic segments from returning more work to the hand than they took from it. The tank
 * holds the work that the hand has done since the contact began. Between two frames that is the
 * mean of both forces times the motion of the device.
 *
 * <p>The spring of the coupling alone holds f^2/(2k) at a force f. If the hand goes on as in the
 * last frame and leaves the solid at once, it gets back half the force times that motion. A force
 * for which the tank holds less is lowered to what it does hold. So a force that may not be
 * returned in full fades as the hand retreats, by at most k times the motion in each frame.
 *
 * <p>Reference: Hannaford and Ryu 2002, "Time-domain passivity control of haptic interfaces".
 * Haptic thread; allocates nothing after construction.
 */
final class EnergyTank {
  /** The work that may be returned for each unit of work that was taken. */
  static final double RETURNED_PER_TAKEN = 1.005;

  private final Vec3 lastDeviceMm = new Vec3();
  private final Vec3 lastForceNewton = new Vec3();
  private final Vec3 motionMm = new Vec3();

  /** The work that may be returned, N mm. */
  private double held;

  /** Whether the point was placed anew, so that a force may act that no motion has built up. */
  private boolean placed = true;

  private long loweredFrames;

  /** Lets the next force begin without work, because the point was placed anew. */
  void restart() {
    placed = true;
  }

  /**
   * Lowers the force of a frame if the tank holds too little for it.
   *
   * @param deviceMm along the axes of the grid
   * @param pathMm the distance from the device to where the material would be without a force. The
   *     product with the force bounds the work that the material can hold
   * @param newtonPerMm the stiffness of the coupling
   * @param forceNewton force on the hand, lowered in place
   */
  void limit(Vec3 deviceMm, double pathMm, double newtonPerMm, Vec3 forceNewton) {
    double newton = forceNewton.length();
    double most = newton * pathMm;
    if (newton == 0) {
      held = 0;
    } else if (placed) {
      held = 0.5 * most;
    } else {
      deviceMm.sub(lastDeviceMm, motionMm);
      takeAndReturn(newton * newton / (2 * newtonPerMm), forceNewton);
      held = Math.max(0, Math.min(held, most));
    }
    placed = false;
    lastDeviceMm.set(deviceMm);
    lastForceNewton.set(forceNewton);
  }

  private void takeAndReturn(double spring, Vec3 forceNewton) {
    double byLast = -0.5 * lastForceNewton.dot(motionMm);
    double byNext = -0.5 * forceNewton.dot(motionMm);
    double part = affordablePart(held + byLast, byNext, spring);
    part = Math.min(part, leavingPart(held + byLast, byNext));
    if (part < 1) {
      forceNewton.mul(part, forceNewton);
      loweredFrames++;
    }
    double taken = byLast + part * byNext;
    held += taken > 0 ? RETURNED_PER_TAKEN * taken : taken;
  }

  /**
   * Returns the largest part s of a force, at most 1, for which {@code before} and s times {@code
   * byNext} are together at least s^2 times {@code spring}; 0 if there is none.
   */
  private static double affordablePart(double before, double byNext, double spring) {
    if (before + byNext >= spring) {
      return 1;
    }
    if (byNext > 2 * spring) {
      return 0; // The parts for which the work suffices are all above 1.
    }
    double square = byNext * byNext + 4 * spring * before;
    return square > 0 ? Math.max(0, Math.min(1, (byNext + Math.sqrt(square)) / (2 * spring))) : 0;
  }

  /**
   * Returns the largest part of a force, at most 1, after which the tank still holds what one more
   * motion like the last returns. If the hand presses on, such a motion returns nothing.
   */
  private static double leavingPart(double before, double byNext) {
    double needed = -2 * byNext;
    return needed <= 0 || before >= needed ? 1 : Math.max(0, before / needed);
  }

  /** Returns the number of frames whose force was lowered. */
  long loweredFrames() {
    return loweredFrames;
  }
}
