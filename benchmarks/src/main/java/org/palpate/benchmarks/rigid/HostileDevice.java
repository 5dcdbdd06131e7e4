package org.palpate.benchmarks.rigid;

import java.util.SplittableRandom;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * A device that jumps, turns by up to half a turn, pushes slowly, rests, flips the sign of its
 * quaternion, and sends reports that are not poses. One thread.
 */
final class HostileDevice {
  private static final int FRAMES_PER_PHASE = 40;
  private static final double JUMP_VOXELS = 50;

  private final SplittableRandom random;
  private final double edgeMm;
  private final double reachMm;
  private final Pose pose = new Pose();
  private final Pose reported = new Pose();
  private final Quaternion scratch = new Quaternion();
  private final Vec3 shift = new Vec3();
  private final Vec3 turn = new Vec3();
  private int frame;

  /**
   * Creates a device.
   *
   * @param edgeMm the shortest edge of a voxel, mm
   * @param reachMm the device stays within this of the origin along each axis, mm
   */
  HostileDevice(SplittableRandom random, double edgeMm, double reachMm) {
    this.random = random;
    this.edgeMm = edgeMm;
    this.reachMm = reachMm;
  }

  /** Returns the next report; it is overwritten by the next call. */
  Pose next() {
    int phase = frame++ / FRAMES_PER_PHASE % 4;
    switch (phase) {
      case 0 -> move(JUMP_VOXELS, Math.PI);
      case 1 -> move(0.3, 0.1);
      case 2 -> move(2, 0.1);
      default -> {} // rests
    }
    for (int axis = 0; axis < 3; axis++) {
      double at = pose.translation.get(axis);
      pose.translation.set(axis, Math.max(-reachMm, Math.min(reachMm, at)));
    }
    return report();
  }

  private void move(double voxels, double radians) {
    for (int axis = 0; axis < 3; axis++) {
      shift.set(axis, voxels * edgeMm * random.nextDouble(-1, 1));
      turn.set(axis, radians * random.nextDouble(-1, 1));
    }
    pose.displace(shift, turn, 1, scratch, pose);
  }

  private Pose report() {
    reported.set(pose);
    if (frame % 3 == 0) {
      reported.rotation.negate(reported.rotation);
    }
    switch (random.nextInt(200)) {
      case 0 -> reported.translation.x = Double.NaN;
      case 1 -> reported.rotation.set(0, 0, 0, 0);
      case 2 -> reported.rotation.z = Double.POSITIVE_INFINITY;
      case 3 -> reported.translation.y = Double.NEGATIVE_INFINITY;
      case 4 -> reported.translation.z = 1e12;
      case 5 -> reported.rotation.set(3, 0, 0, 0);
      default -> {}
    }
    return reported;
  }
}
