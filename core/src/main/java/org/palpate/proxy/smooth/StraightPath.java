package org.palpate.proxy.smooth;

import org.palpate.geometry.Vec3;
import org.palpate.proxy.smooth.field.OccupancyField;

/** The straight segment from the interaction point to the device. */
final class StraightPath {
  private final OccupancyField field;
  private final VerifiedMotion motion;

  /** Whether the device's cell is solid, so that every segment to it counts as blocked. */
  private boolean deviceInSolid;

  StraightPath(OccupancyField field, VerifiedMotion motion) {
    this.field = field;
    this.motion = motion;
  }

  /** Begins a frame. */
  void beginFrame(Vec3 device) {
    deviceInSolid = field.isSolid(device);
  }

  /**
   * Whether the device lies in a solid cell of the field. On long voxels that may be a thin slice
   * within an empty voxel.
   */
  boolean isDeviceInSolid() {
    return deviceInSolid;
  }

  /** Whether a solid lies between the point and the device. */
  boolean isBlocked(Vec3 device) {
    return deviceInSolid || !motion.isFree(device);
  }

  /** Proposes and verifies a leg to a device that w_max reaches. */
  boolean verifyToDevice(Vec3 device) {
    return !deviceInSolid && motion.verify(device);
  }

  /** Proposes and verifies a leg towards the device, as far as w_max allows. */
  boolean verifyTowardsDevice(Vec3 device) {
    return motion.reaches(device) ? verifyToDevice(device) : motion.verify(device);
  }
}
