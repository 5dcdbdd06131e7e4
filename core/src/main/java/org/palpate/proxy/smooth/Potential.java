package org.palpate.proxy.smooth;

import org.palpate.geometry.Vec3;
import org.palpate.proxy.smooth.field.FieldSample;
import org.palpate.proxy.smooth.field.OccupancyField;
import org.palpate.proxy.smooth.field.SeedCell;

/**
 * The function that a point at rest minimizes: its distance to the device, less most of its height
 * above the isosurface, plus its weighted depth below. In shortest voxel edges.
 *
 * <p>It depends on point, device and solids alone, to the last bit. It is bounded below, because
 * both height and depth are.
 */
final class Potential {
  /**
   * The weight of an edge of depth against an edge of distance. Above 1, so that leaving the inside
   * lowers the potential; twice that, because the field is flatter in places.
   */
  private static final double DEPTH_WEIGHT = 2;

  /**
   * The weight of an edge of height against an edge of distance. Nearly 1, so that passing over
   * voxels that stand out hardly raises the potential; below 1, so that coming down lowers it.
   */
  private static final double HEIGHT_WEIGHT = 0.98;

  private final OccupancyField field;
  private final EdgeUnits units;
  private final SeedCell seed = new SeedCell();

  Potential(OccupancyField field, EdgeUnits units) {
    this.field = field;
    this.units = units;
  }

  /** Returns the potential of {@code point}. */
  double at(Vec3 point, Vec3 device) {
    return at(point, units.distance(point, device));
  }

  /** Returns the potential of {@code point}, given its distance to the device. */
  double at(Vec3 point, double distanceEdges) {
    FieldSample sample = field.evaluate(seed.set(point), point);
    double height = sample.boundedHeightEdges();
    if (height > 0) {
      return distanceEdges - HEIGHT_WEIGHT * height;
    }
    return distanceEdges - DEPTH_WEIGHT * height;
  }
}
