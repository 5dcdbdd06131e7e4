package org.palpate.rigid;

import org.palpate.geometry.Pose;

/**
 * Makes a target of whatever a device reports: a unit quaternion on the tool's side, positions that
 * doubles can resolve. A report that is no pose (a NaN, an infinity, a quaternion without
 * direction) leaves the target as it was.
 */
final class DevicePoseFilter {
  /** Farther out than this along an axis, positions are cut off, mm. */
  private static final double FARTHEST_MM = 1e9;

  private final Pose target = new Pose();
  private final Pose checked = new Pose();
  private boolean known;

  /** Forgets the last target. */
  void reset() {
    known = false;
  }

  /** Whether there was a pose so far. */
  boolean isKnown() {
    return known;
  }

  /** Returns the target; not to be written. */
  Pose target() {
    return target;
  }

  /**
   * Takes a report.
   *
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
