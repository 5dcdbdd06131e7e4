package org.palpate.rigid;

import java.util.SplittableRandom;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.testing.RandomGeometry;

/**
 * A hostile device: jumps of 50 voxels and half turns, slow pushes, rests, sign flips of the
 * quaternion, and reports that are no poses at all.
 */
final class HostilePoses {
  private final SplittableRandom random;
  private final double size;
  private final Pose pose = new Pose();
  private final Pose reported = new Pose();
  private final Quaternion scratch = new Quaternion();
  private int frame;

  HostilePoses(SplittableRandom random, double size) {
    this.random = random;
    this.size = size;
  }

  /** Returns the last pose that was one. */
  Pose lastPose() {
    return pose;
  }

  /** Returns the next report. It is overwritten by the next call, and need not be a pose. */
  Pose next() {
    frame++;
    int phase = frame / 40 % 4;
    if (phase == 0) {
      jump();
    } else if (phase < 3) {
      double reach = phase == 1 ? 0.3 : 2;
      pose.displace(
          RandomGeometry.vector(random, reach),
          RandomGeometry.vector(random, 0.1),
          1,
          scratch,
          pose);
    }
    for (int axis = 0; axis < 3; axis++) {
      double v = pose.translation.get(axis);
      pose.translation.set(axis, Math.max(-size, Math.min(size, v)));
    }
    return spoil();
  }

  private void jump() {
    pose.displace(
        RandomGeometry.vector(random, 50), RandomGeometry.vector(random, 2), 1, scratch, pose);
  }

  private Pose spoil() {
    reported.set(pose);
    if (frame % 3 == 0) {
      reported.rotation.negate(reported.rotation);
    }
    switch (frame % 211) {
      case 5 -> reported.translation.x = Double.NaN;
      case 17 -> reported.rotation.set(0, 0, 0, 0);
      case 29 -> reported.rotation.z = Double.POSITIVE_INFINITY;
      case 41 -> reported.translation.y = Double.NEGATIVE_INFINITY;
      case 53 -> reported.rotation.w = Double.NaN;
      case 67 -> reported.translation.z = 1e12;
      case 79 -> reported.rotation.set(3, 0, 0, 0);
      case 97 -> reported.translation.set(-1e300, 1e300, 0);
      default -> {}
    }
    return reported;
  }
}
