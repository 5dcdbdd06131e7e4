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
 * One frame's walk of the interaction point, as the baselines take it: where p is, how far it may
 * still go, and the steps that both make. Owned scratch; points are grid coordinates.
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
  private CollisionScene obstacles;
  private LegPath legs;

  ReferencePath(RayCaster caster, GridMetric metric, double maxPathMm) {
    if (!(maxPathMm > 0)) {
      throw new IllegalArgumentException("maxPathMm must be positive: maxPathMm=" + maxPathMm);
    }
    this.caster = caster;
    this.metric = metric;
    this.maxPathMm = maxPathMm;
  }

  void begin(CollisionScene frameObstacles, Vec3 device, InteractionPoint point) {
    obstacles = frameObstacles;
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

  boolean mayGoOn() {
    return legs.lengthMm() < maxPathMm && !legs.isFull();
  }

  double leftMm() {
    return maxPathMm - legs.lengthMm();
  }

  /** The collision test from p to the device; fills {@link #collision} where there is one. */
  boolean meetsSolidOnWayToDevice() {
    ray.from(x, y, z).to(deviceX, deviceY, deviceZ);
    return obstacles.cast(caster, ray, collision);
  }

  /** Whether a point lies in a solid voxel, by its rounded-down coordinates. */
  boolean isSolidAt(double atX, double atY, double atZ) {
    return obstacles.isSolid((int) Math.floor(atX), (int) Math.floor(atY), (int) Math.floor(atZ));
  }

  double voxelsToDevice() {
    double u = deviceX - x;
    double v = deviceY - y;
    double w = deviceZ - z;
    return Math.sqrt(u * u + v * v + w * w);
  }

  /** Whether p, moved by one voxel towards the device but not past it, were in no solid. */
  boolean isFreeOneVoxelTowardsDevice() {
    double share = Math.min(1, 1 / voxelsToDevice());
    return !isSolidAt(
        x + share * (deviceX - x), y + share * (deviceY - y), z + share * (deviceZ - z));
  }

  /** Moves p straight to a point, or as far as w_max leaves. */
  void moveTowards(double toX, double toY, double toZ, boolean alongSurface) {
    double wholeMm = metric.distance(x, y, z, toX, toY, toZ);
    double leftMm = leftMm();
    if (wholeMm <= leftMm) {
      put(toX, toY, toZ, wholeMm, alongSurface);
    } else {
      double share = leftMm / wholeMm;
      put(
          x + share * (toX - x),
          y + share * (toY - y),
          z + share * (toZ - z),
          leftMm,
          alongSurface);
    }
  }

  /**
   * Moves p along the way to the device until it is {@code epsilonVoxels} before the collision
   * point, or as far as w_max leaves; never back, and never to an end in a solid.
   */
  void moveBeforeCollision(double epsilonVoxels) {
    double share = collision.t - epsilonVoxels / voxelsToDevice();
    if (!(share > 0)) {
      return;
    }
    double wholeMm = metric.distance(x, y, z, deviceX, deviceY, deviceZ);
    share = Math.min(share, leftMm() / wholeMm);
    double toX = x + share * (deviceX - x);
    double toY = y + share * (deviceY - y);
    double toZ = z + share * (deviceZ - z);
    if (!isSolidAt(toX, toY, toZ)) {
      put(toX, toY, toZ, share * wholeMm, false);
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
   * Moves p along the surface to a voxel's centre, or as far as w_max leaves, and takes the move
   * back where it ends in a solid. False where p stays.
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

  CollisionScene obstacles() {
    return obstacles;
  }

  GridMetric metric() {
    return metric;
  }
}
