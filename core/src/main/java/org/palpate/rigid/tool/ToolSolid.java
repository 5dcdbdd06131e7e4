package org.palpate.rigid.tool;

import org.palpate.geometry.Vec3;

/** The closed solid that a tool's points were sampled from, in the tool frame. Immutable. */
@FunctionalInterface
public interface ToolSolid {
  /**
   * {@return whether the solid holds a point}
   *
   * @param x the point along x, tool frame, mm
   * @param y its y component
   * @param z its z component
   */
  boolean contains(double x, double y, double z);

  /**
   * Writes the lowest point, along a direction, of the curved surface around a sample point. It is
   * the sample point itself where the surface is not known to be curved, or where the lowest point
   * is too far away.
   *
   * @param sample a sample point, tool frame, mm
   * @param up unit, tool frame
   * @param withinMm the search reaches at least this far from the sample, mm
   * @param dest written, tool frame, mm; may be {@code sample}
   * @return {@code dest}
   */
  default Vec3 lowestNear(Vec3 sample, Vec3 up, double withinMm, Vec3 dest) {
    return dest.set(sample);
  }
}
