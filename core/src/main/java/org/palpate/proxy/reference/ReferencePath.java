package org.palpate.proxy.reference;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.RayHit;

/**
 * The path of the interaction point in one frame of a baseline: the position of p, the remaining
 * path, and the motions that both baselines share. Owned scratch; points are grid coordinates.
 */
final class ReferencePath {
  final RayHit collision = new RayHit();
  double x;
  double y;
  double z;
  double deviceX;
  double deviceY;
  double deviceZ;

  private final RayCaster caster;
  private final GridMetric metric;
  private final double maxPathMm;
  private final Ray ray = new Ray();
  private CollisionScene scene;
  private LegPath legs;

  ReferencePath(RayCaster caster, GridMetric metric, double maxPathMm) {
    if (!(maxPathMm > 0)) {
      throw new IllegalArgumentException("maxPathMm must be positive: maxPathMm=" + maxPathMm);
    }
    this.caster = caster;
    this.metric = metric;
    this.maxPathMm = maxPathMm;
  }

  /** Begins a frame: removes the legs of the last one and takes over p and the device. */
  void begin(CollisionScene frameScene, Vec3 device, InteractionPoint point) {
    scene = frameScene;
    legs = point.legs;
    legs.clear();
    x = point.position.x;
    y = point.position.y;
    z = point.position.z;
    deviceX = device.x;
    deviceY = device.y;
    deviceZ = device.z;
  }

  boolean isAtDevice() {
    return x == deviceX && y == deviceY && z == deviceZ;
  }

  /** Whether there is path, and room for another leg, in this frame. */
  boolean mayGoOn() {
    return legs.lengthMm() < maxPathMm && !legs.isFull();
  }

  private double remainingMm() {
    return maxPathMm - legs.lengthMm();
  }

  /** Whether the segment from p to the device meets a solid; if so, sets {@link #collision}. */
  boolean meetsSolidBeforeDevice() {
    ray.from(x, y, z).to(deviceX, deviceY, deviceZ);
    return scene.cast(caster, ray, collision);
  }

  /** Whether a point lies in a solid voxel, by its rounded-down coordinates. */
  private boolean isSolidAt(double atX, double atY, double atZ) {
    return scene.isSolid((int) Math.floor(atX), (int) Math.floor(atY), (int) Math.floor(atZ));
  }

  private double voxelsToDevice() {
    double u = deviceX - x;
    double v = deviceY - y;
    double w = deviceZ - z;
    return Math.sqrt(u * u + v * v + w * w);
  }

  /** Whether p would be in no solid after one voxel towards the device, but not past it. */
  boolean isFreeOneVoxelTowardsDevice() {
    double fraction = Math.min(1, 1 / voxelsToDevice());
    return !isSolidAt(
        x + fraction * (deviceX - x), y + fraction * (deviceY - y), z + fraction * (deviceZ - z));
  }

  /** Moves p straight to a point, or as far as the remaining path allows. */
  void moveTowards(double toX, double toY, double toZ, boolean alongSurface) {
    double wholeMm = metric.distance(x, y, z, toX, toY, toZ);
    double remainingMm = remainingMm();
    if (wholeMm <= remainingMm) {
      put(toX, toY, toZ, wholeMm, alongSurface);
    } else {
      double fraction = remainingMm / wholeMm;
      put(
          x + fraction * (toX - x),
          y + fraction * (toY - y),
          z + fraction * (toZ - z),
          remainingMm,
          alongSurface);
    }
  }

  /**
   * Moves p towards the device until it is {@code epsilonVoxels} before the collision point, or as
   * far as the remaining path allows; never back, and never to an end in a solid.
   */
  void moveBeforeCollision(double epsilonVoxels) {
    double fraction = collision.t - epsilonVoxels / voxelsToDevice();
    if (!(fraction > 0)) {
      return;
    }
    double wholeMm = metric.distance(x, y, z, deviceX, deviceY, deviceZ);
    fraction = Math.min(fraction, remainingMm() / wholeMm);
    double toX = x + fraction * (deviceX - x);
    double toY = y + fraction * (deviceY - y);
    double toZ = z + fraction * (deviceZ - z);
    if (!isSolidAt(toX, toY, toZ)) {
      put(toX, toY, toZ, fraction * wholeMm, false);
    }
  }

  private void put(double toX, double toY, double toZ, double lengthMm, boolean alongSurface) {
    if (toX == x && toY == y && toZ == z) {
      return;
    }
    legs.add(x, y, z, toX, toY, toZ, lengthMm, alongSurface);
    x = toX;
    y = toY;
    z = toZ;
  }

  /**
   * Moves p along the surface to the centre of a voxel, or as far as the remaining path allows, and
   * takes the motion back if it ends in a solid.
   *
   * @return whether p moved
   */
  boolean moveToVoxel(double centreX, double centreY, double centreZ) {
    double fromX = x;
    double fromY = y;
    double fromZ = z;
    int legCount = legs.count();
    double lengthMm = legs.lengthMm();
    moveTowards(centreX, centreY, centreZ, true);
    if (legs.count() > legCount && isSolidAt(x, y, z)) {
      legs.truncate(legCount, lengthMm);
      x = fromX;
      y = fromY;
      z = fromZ;
    }
    return legs.count() > legCount;
  }

  CollisionScene scene() {
    return scene;
  }

  GridMetric metric() {
    return metric;
  }
}
