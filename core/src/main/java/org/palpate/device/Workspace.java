package org.palpate.device;

import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * How a device's own frame (millimetres, x right, y up, z towards the person) lies in the world: it
 * is turned, then scaled along the world's axes, then moved.
 *
 * <p>A force goes the way back by the transpose, divided by the largest scale. So it does no more
 * work on the hand than the spring in the world did, whatever the scales are, and a world stiffness
 * of {@link #stiffnessNewtonPerMm} is felt along no direction as more than its share of the
 * device's maximum.
 *
 * @param deviceToWorld rotation, and where the device's origin goes, world mm; no mirroring
 * @param scale world mm per device mm along each world axis, positive
 */
public record Workspace(RigidTransform deviceToWorld, Vec3 scale) {

  /** Checks the axes and scales. */
  public Workspace {
    if (!deviceToWorld.isOrthonormal() || determinant(deviceToWorld) < 0) {
      throw new IllegalArgumentException("axes must be a rotation: deviceToWorld=" + deviceToWorld);
    }
    if (!scale.isFinite() || scale.x <= 0 || scale.y <= 0 || scale.z <= 0) {
      throw new IllegalArgumentException("scale must be positive: scale=" + scale);
    }
  }

  /**
   * The workspace whose ball reaches every corner plane of a box: one scale for all axes, so that
   * shapes keep their proportions.
   *
   * @param device whose ball it is
   * @param axes device to world; its origin is not used
   * @param lowMm least corner of the box, world mm
   * @param highMm greatest corner
   */
  public static Workspace fit(
      DeviceSpecification device, RigidTransform axes, Vec3 lowMm, Vec3 highMm) {
    Workspace each = fitEachAxis(device, axes, lowMm, highMm);
    double largest = each.largestScale();
    return new Workspace(each.deviceToWorld, new Vec3(largest, largest, largest));
  }

  /** As {@link #fit}, with a scale for each axis, so that the whole reach is used along all. */
  public static Workspace fitEachAxis(
      DeviceSpecification device, RigidTransform axes, Vec3 lowMm, Vec3 highMm) {
    double reachMm = device.workspaceRadiusMm();
    if (!(reachMm > 0)) {
      throw new IllegalArgumentException("workspaceRadiusMm must be positive: " + reachMm);
    }
    Vec3 centre = lowMm.add(highMm, new Vec3()).mul(0.5, new Vec3());
    Vec3 scale = highMm.sub(lowMm, new Vec3()).mul(0.5 / reachMm, new Vec3());
    return new Workspace(
        new RigidTransform(axes.axisX(), axes.axisY(), axes.axisZ(), centre), scale);
  }

  /** The largest of the three scales. */
  public double largestScale() {
    return Math.max(scale.x, Math.max(scale.y, scale.z));
  }

  /**
   * The world stiffness, N per mm of scan, that the hand feels as {@code share} of what the device
   * renders stably.
   */
  public double stiffnessNewtonPerMm(DeviceSpecification device, double share) {
    return share * device.maxStiffnessNewtonPerMm() / largestScale();
  }

  /** Writes where a device position lies into {@code dest}, world mm; {@code dest} may be it. */
  public Vec3 toWorld(Vec3 deviceMm, Vec3 dest) {
    return toWorldStep(deviceMm, dest).add(deviceToWorld.origin(), dest);
  }

  /** Writes where a movement of the device goes into {@code dest}, world mm. */
  Vec3 toWorldStep(Vec3 deviceMm, Vec3 dest) {
    deviceToWorld.rotate(deviceMm, dest);
    return dest.set(dest.x * scale.x, dest.y * scale.y, dest.z * scale.z);
  }

  /** Writes the force to send to the device for one in the world into {@code dest}, newtons. */
  public Vec3 toDeviceForce(Vec3 worldNewton, Vec3 dest) {
    double unit = 1 / largestScale();
    dest.set(
        worldNewton.x * scale.x * unit,
        worldNewton.y * scale.y * unit,
        worldNewton.z * scale.z * unit);
    return deviceToWorld.inverseRotate(dest, dest);
  }

  private static double determinant(RigidTransform t) {
    Vec3 x = t.axisX();
    Vec3 y = t.axisY();
    Vec3 z = t.axisZ();
    return x.x * (y.y * z.z - y.z * z.y)
        - y.x * (x.y * z.z - x.z * z.y)
        + z.x * (x.y * y.z - x.z * y.y);
  }
}
