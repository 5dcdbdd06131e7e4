package org.palpate.proxy.smooth;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;

/** The straight segment from the interaction point to the device. */
final class StraightPath {
  private final VerifiedMotion motion;

  /** Whether the device's cell is solid, so that every segment to it is blocked. */
  private boolean deviceInSolid;

  StraightPath(VerifiedMotion motion) {
    this.motion = motion;
  }

  /** Begins a frame. */
  void beginFrame(CollisionScene scene, Vec3 device) {
    deviceInSolid =
        scene.isSolid(
            (int) Math.floor(device.x), (int) Math.floor(device.y), (int) Math.floor(device.z));
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
