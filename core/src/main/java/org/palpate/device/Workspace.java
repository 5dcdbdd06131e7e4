package org.palpate.device;

import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * Maps a device's own frame to the world: a rotation, then a scale along each world axis, then a
 * translation. The device's frame is in millimetres, x right, y up, z towards the person.
 *
 * <p>A force is mapped back by the transpose, divided by the largest scale. Whatever the scales
 * are, it therefore does no more work on the hand than the spring does in the world. A world
 * stiffness of {@link #stiffnessNewtonPerMm} is felt in no direction as more than the given
 * fraction of the device's maximum.
 *
 * @param deviceToWorld rotation without mirroring, and the position of the device's origin, world
 *     mm
 * @param scale world mm per device mm along each world axis, positive
 */
public record Workspace(RigidTransform deviceToWorld, Vec3 scale) {

  /**
   * Checks the axes and scales.
   *
   * @throws IllegalArgumentException if the axes are no rotation or a scale is not positive
   */
  public Workspace {
    if (!deviceToWorld.isOrthonormal() || deviceToWorld.isMirrored()) {
      throw new IllegalArgumentException("axes must be a rotation: deviceToWorld=" + deviceToWorld);
    }
    if (!scale.isFinite() || scale.x <= 0 || scale.y <= 0 || scale.z <= 0) {
      throw new IllegalArgumentException("scale must be positive: scale=" + scale);
    }
  }

  /**
   * {@return the workspace in which the device reaches every face of a box} All axes have the same
   * scale, so that shapes keep their proportions.
   *
   * @param device the device, for its radius
   * @param axes device to world; its origin is not used
   * @param lowMm lowest corner of the box, world mm
   * @param highMm highest corner
   * @throws IllegalArgumentException if the device has no radius
   */
  public static Workspace fit(
      DeviceSpecification device, RigidTransform axes, Vec3 lowMm, Vec3 highMm) {
    Workspace each = fitEachAxis(device, axes, lowMm, highMm);
    double largest = each.largestScale();
    return new Workspace(each.deviceToWorld, new Vec3(largest, largest, largest));
  }

  /**
   * {@return a workspace as {@link #fit}, but with a scale for each axis that uses its reach}
   *
   * @param device the device, for its radius
   * @param axes device to world; its origin is not used
   * @param lowMm lowest corner of the box, world mm
   * @param highMm highest corner
   * @throws IllegalArgumentException if the device has no radius
   */
  public static Workspace fitEachAxis(
      DeviceSpecification device, RigidTransform axes, Vec3 lowMm, Vec3 highMm) {
    double reachMm = device.workspaceRadiusMm();
    if (!(reachMm > 0)) {
      throw new IllegalArgumentException(
          "workspaceRadiusMm must be positive: workspaceRadiusMm=" + reachMm);
    }
    Vec3 centre = lowMm.add(highMm, new Vec3()).mul(0.5, new Vec3());
    Vec3 scale = highMm.sub(lowMm, new Vec3()).mul(0.5 / reachMm, new Vec3());
    return new Workspace(
        new RigidTransform(axes.axisX(), axes.axisY(), axes.axisZ(), centre), scale);
  }

  /** {@return the largest of the three scales} */
  public double largestScale() {
    return Math.max(scale.x, Math.max(scale.y, scale.z));
  }

  /**
   * {@return the world stiffness that the hand feels as a fraction of the stiffness that the device
   * renders stably, N per mm of scan}
   *
   * @param device states the largest stiffness that it renders stably
   * @param fraction the part of that stiffness, from 0 to 1
   */
  public double stiffnessNewtonPerMm(DeviceSpecification device, double fraction) {
    return fraction * device.maxStiffnessNewtonPerMm() / largestScale();
  }

  /**
   * Writes the world position of a device position.
   *
   * @param deviceMm the position in the device's frame, mm
   * @param dest receives the position, world mm; may be {@code deviceMm}
   * @return {@code dest}
   */
  public Vec3 toWorld(Vec3 deviceMm, Vec3 dest) {
    return toWorldStep(deviceMm, dest).add(deviceToWorld.origin(), dest);
  }

  /** Writes the world displacement of a displacement of the device into {@code dest}, mm. */
  Vec3 toWorldStep(Vec3 deviceMm, Vec3 dest) {
    deviceToWorld.rotate(deviceMm, dest);
    return dest.set(dest.x * scale.x, dest.y * scale.y, dest.z * scale.z);
  }

  /**
   * Writes the device's force for a force in the world.
   *
   * @param worldNewton the force along the world's axes, N
   * @param dest receives the force along the device's axes, N; may be {@code worldNewton}
   * @return {@code dest}
   */
  public Vec3 toDeviceForce(Vec3 worldNewton, Vec3 dest) {
    double unit = 1 / largestScale();
    dest.set(
        worldNewton.x * scale.x * unit,
        worldNewton.y * scale.y * unit,
        worldNewton.z * scale.z * unit);
    return deviceToWorld.inverseRotate(dest, dest);
  }

  /**
   * Writes the device's torque for a torque in the world. The device does as large a part of the
   * spring's work by turning as by moving, so the torque is divided by the largest scale.
   *
   * @param worldNewtonMm the torque along the world's axes, N mm
   * @param dest receives the torque along the device's axes, N mm; may be {@code worldNewtonMm}
   * @return {@code dest}
   */
  public Vec3 toDeviceTorque(Vec3 worldNewtonMm, Vec3 dest) {
    deviceToWorld.inverseRotate(worldNewtonMm, dest);
    return dest.mul(1 / largestScale(), dest);
  }
}
