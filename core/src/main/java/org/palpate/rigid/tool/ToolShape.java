package org.palpate.rigid.tool;

import java.util.Optional;
import org.palpate.geometry.Vec3;

/**
 * A closed solid of simple form from which a tool is made. Frame: its own, mm. Immutable; any
 * thread.
 */
public sealed interface ToolShape permits BoxShape, RodShape {
  /** Takes points one after the other. */
  @FunctionalInterface
  interface PointSink {
    /**
     * Takes a point.
     *
     * @param x the point along x, frame of the shape, mm
     * @param y its y component
     * @param z its z component
     */
    void add(double x, double y, double z);
  }

  /**
   * {@return whether the closed solid contains a point}
   *
   * @param x the point along x, frame of the shape, mm
   * @param y its y component
   * @param z its z component
   */
  boolean contains(double x, double y, double z);

  /** {@return the low corner of a box around the solid, mm} */
  Vec3 low();

  /** {@return the high corner of a box around the solid, mm} */
  Vec3 high();

  /** {@return the area of the surface, mm^2} */
  double areaMm2();

  /** {@return volume, centroid and second moments, by formula} */
  MassProperties massProperties();

  /**
   * {@return the points of the solid that lie deeper than a distance below its surface; empty if
   * none does}
   *
   * @param depthMm the distance, mm, positive
   */
  Optional<ToolShape> eroded(double depthMm);

  /**
   * Writes the lowest point, along a direction, of the curved surface around a sample. It is the
   * sample itself where the surface is flat, or where the lowest point is too far away.
   *
   * @param sample a sample of the surface, mm
   * @param up unit
   * @param withinMm the search reaches at least this far from the sample, mm
   * @param dest written; may be {@code sample}
   * @return {@code dest}
   */
  default Vec3 lowestNear(Vec3 sample, Vec3 up, double withinMm, Vec3 dest) {
    return dest.set(sample);
  }

  /**
   * Samples the surface so that each point of it lies within a distance of a sample. Makes about
   * {@code areaMm2() / (2 coverRadiusMm^2)} samples.
   *
   * @param coverRadiusMm that distance, positive
   * @param sink takes the samples
   */
  void sampleSurface(double coverRadiusMm, PointSink sink);
}
