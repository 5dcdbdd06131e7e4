package org.palpate.rigid;

import org.palpate.geometry.Vec3;

/**
 * A closed solid of simple form from which a tool is made, in a frame of its own, mm. Immutable.
 */
public interface ToolShape {
  /** Takes points one after the other. */
  @FunctionalInterface
  interface PointSink {
    /** Takes a point, mm. */
    void add(double x, double y, double z);
  }

  /** Whether the closed solid holds the point, mm. */
  boolean contains(double x, double y, double z);

  /** Returns the low corner of a box around the solid, mm. */
  Vec3 low();

  /** Returns the high corner of a box around the solid, mm. */
  Vec3 high();

  /**
   * Samples the surface so that every point of it lies within a distance of a sample.
   *
   * @param coverRadiusMm that distance, positive
   * @param sink takes the samples
   */
  void sampleSurface(double coverRadiusMm, PointSink sink);
}
