package org.palpate.rigid;

import org.palpate.geometry.Pose;

/**
 * Makes the target of a frame from a device report. The quaternion is normalized and has the sign
 * that is nearer to the tool's; positions are clamped to what doubles can resolve. A report with a
 * NaN, an infinity or a quaternion of norm 0 is ignored. Haptic thread only.
 */
final class DevicePoseFilter {
  /** Positions are clamped to this along each axis, mm. */
  private static final double FARTHEST_MM = 1e9;

  private final Pose target = new Pose();
  private final Pose checked = new Pose();
  private boolean known;

  /** Whether any report was a pose so far. */
  boolean isKnown() {
    return known;
  }

  /** Returns the target, which the solver moves to the nearest pose that its mover can have. */
  Pose target() {
    return target;
  }

  /**
   * Updates the target from a report.
   *
   * @param device the report, which need not be a pose
   * @param tool the tool pose, which decides between a quaternion and its negative
   */
  void take(Pose device, Pose tool) {
    checked.set(device);
    if (!checked.translation.isFinite() || !checked.rotation.normalize()) {
      return;
    }
    for (int axis = 0; axis < 3; axis++) {
      double v = checked.translation.get(axis);
      checked.translation.set(axis, Math.max(-FARTHEST_MM, Math.min(FARTHEST_MM, v)));
    }
    if (checked.rotation.dot(tool.rotation) < 0) {
      checked.rotation.negate(checked.rotation);
    }
    target.set(checked);
    known = true;
  }
}
