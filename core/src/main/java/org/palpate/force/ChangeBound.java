package org.palpate.force;

import org.palpate.geometry.Vec3;

/**
 * Bounds the change of a force from one frame to the next. The hand then feels a push that builds
 * up, and not a knock. Stateless; allocates nothing.
 */
final class ChangeBound {
  /**
   * The least motion of the hand that counts in a frame of a millisecond, in shortest voxel edges;
   * see {@link FramePart}. A change of the force therefore arrives at a hand at rest too.
   */
  static final double MIN_MOTION_EDGES = 0.05;

  private ChangeBound() {}

  /**
   * Returns the largest permitted change of a coupling force in one frame, N: its stiffness times
   * the motion of the hand.
   *
   * @param motionMm motion of the hand since the last frame
   * @param minMotionMm the motion that counts if the hand moves less
   */
  static double ofMotion(double stiffnessNewtonPerMm, double motionMm, double minMotionMm) {
    return stiffnessNewtonPerMm * Math.max(motionMm, minMotionMm);
  }

  /**
   * Shortens the step from the last force to {@code force} to the bound, if it is longer.
   *
   * @param last the force of the last frame
   * @param maxChange the longest permitted step, N
   * @param force changed in place
   * @return whether the step was longer than the bound
   */
  static boolean apply(Vec3 last, double maxChange, Vec3 force) {
    double x = force.x - last.x;
    double y = force.y - last.y;
    double z = force.z - last.z;
    double change = Math.sqrt(x * x + y * y + z * z);
    if (change > maxChange) {
      double fraction = maxChange / change;
      force.set(last.x + fraction * x, last.y + fraction * y, last.z + fraction * z);
      return true;
    }
    return false;
  }
}
