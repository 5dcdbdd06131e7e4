package org.palpate.proxy.smooth;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;

/**
 * Converts between grid coordinates, in which positions are stored, and lengths in shortest voxel
 * edges ("edges"), in which the surface is described. On an isotropic grid they are the same.
 */
final class EdgeUnits {
  private final GridMetric metric;
  private final double shortestMm;
  private final double x;
  private final double y;
  private final double z;

  EdgeUnits(GridMetric metric) {
    this.metric = metric;
    shortestMm = metric.shortestEdgeMm();
    x = metric.spacingX() / shortestMm;
    y = metric.spacingY() / shortestMm;
    z = metric.spacingZ() / shortestMm;
  }

  /** Returns the edge of a voxel along x, in edges. */
  double x() {
    return x;
  }

  /** Returns the edge of a voxel along y, in edges. */
  double y() {
    return y;
  }

  /** Returns the edge of a voxel along z, in edges. */
  double z() {
    return z;
  }

  /** Returns the shortest edge of a voxel, mm. */
  double shortestMm() {
    return shortestMm;
  }

  /** Returns the distance between two positions, in edges. */
  double distance(Vec3 from, Vec3 to) {
    return metric.distance(from.x, from.y, from.z, to.x, to.y, to.z) / shortestMm;
  }

  /** Writes the vector between two positions, in edges. */
  void vector(Vec3 from, Vec3 to, Vec3 dest) {
    dest.set((to.x - from.x) * x, (to.y - from.y) * y, (to.z - from.z) * z);
  }

  /** Returns the height of a position above the plane through another, along a unit normal. */
  double height(Vec3 position, Vec3 onPlane, Vec3 normal) {
    return (position.x - onPlane.x) * x * normal.x
        + (position.y - onPlane.y) * y * normal.y
        + (position.z - onPlane.z) * z * normal.z;
  }

  /** Writes the position that lies {@code edges} away from another, along a direction. */
  void offset(Vec3 from, double edges, Vec3 direction, Vec3 dest) {
    dest.set(
        from.x + edges * direction.x / x,
        from.y + edges * direction.y / y,
        from.z + edges * direction.z / z);
  }
}
