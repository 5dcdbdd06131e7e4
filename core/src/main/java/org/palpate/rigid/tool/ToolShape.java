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
    /** Takes a point, mm. */
    void add(double x, double y, double z);
  }

  /** Whether the closed solid contains the point, mm. */
  boolean contains(double x, double y, double z);

  /** Returns the low corner of a box around the solid, mm. */
  Vec3 low();

  /** Returns the high corner of a box around the solid, mm. */
  Vec3 high();

  /** Returns the area of the surface, mm^2. */
  double areaMm2();

  /** Returns volume, centroid and second moments, by formula. */
  MassProperties massProperties();

  /**
   * Returns the points of the solid that lie deeper than a distance below its surface; empty if
   * none does.
   *
   * @param depthMm the distance, mm, positive
   */
  Optional<ToolShape> eroded(double depthMm);

  /**
   * Samples the surface so that each point of it lies within a distance of a sample. Makes about
   * {@code areaMm2() / (2 coverRadiusMm^2)} samples.
   *
   * @param coverRadiusMm that distance, positive
   * @param sink takes the samples
   */
  void sampleSurface(double coverRadiusMm, PointSink sink);
}
