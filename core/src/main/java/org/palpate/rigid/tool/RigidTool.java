package org.palpate.rigid.tool;

import org.palpate.geometry.PointSet;
import org.palpate.geometry.Vec3;

/**
 * A rigid tool: sample points that must not meet a solid, their tree of bounding spheres, and the
 * kinetic metric of the tool's matter. {@link ToolSampler} makes tools.
 *
 * <p>Frame: the tool frame, mm, with the reference point at the origin. The reference point is the
 * centroid of the matter. Immutable; any thread.
 */
public final class RigidTool implements PointSet {
  /** The cover radius of points that do not cover the surface of their tool. */
  public static final double NOT_COVERED = Double.POSITIVE_INFINITY;

  private final double[] x;
  private final double[] y;
  private final double[] z;
  private final SphereTree tree;
  private final KineticMetric metric;
  private final double coverRadiusMm;
  private final double radiusMm;
  private final Vec3 referenceMm;
  private final ToolSolid solid;

  /**
   * Creates a tool. Keeps the arrays of points and reorders them.
   *
   * @param points the coordinates x, y and z of the sample points, mm
   * @param metric the metric of the tool's matter
   * @param coverRadiusMm the distance within which each surface point of the solid has a sample
   * @param referenceMm the reference point in the frame of the source, mm
   * @param solid the solid that the points were sampled from; null if there is none
   */
  RigidTool(
      double[][] points,
      KineticMetric metric,
      double coverRadiusMm,
      Vec3 referenceMm,
      ToolSolid solid) {
    if (points[0].length == 0) {
      throw new IllegalArgumentException("a tool needs at least one point");
    }
    x = points[0];
    y = points[1];
    z = points[2];
    tree = new SphereTree(x, y, z);
    this.metric = metric;
    this.coverRadiusMm = coverRadiusMm;
    this.referenceMm = referenceMm;
    this.solid = solid;
    radiusMm = farthest();
  }

  private double farthest() {
    double square = 0;
    for (int n = 0; n < x.length; n++) {
      square = Math.max(square, x[n] * x[n] + y[n] * y[n] + z[n] * z[n]);
    }
    return Math.sqrt(square) * (1 + 1e-12);
  }

  /** Returns the number of sample points. */
  @Override
  public int count() {
    return x.length;
  }

  /** Returns the x coordinate of a sample point, mm. */
  @Override
  public double x(int point) {
    return x[point];
  }

  /** Returns the y coordinate of a sample point, mm. */
  @Override
  public double y(int point) {
    return y[point];
  }

  /** Returns the z coordinate of a sample point, mm. */
  @Override
  public double z(int point) {
    return z[point];
  }

  /**
   * Writes a sample point.
   *
   * @param index the index of the point, from 0
   * @param dest receives the point, tool frame, mm
   * @return {@code dest}
   */
  public Vec3 point(int index, Vec3 dest) {
    return dest.set(x[index], y[index], z[index]);
  }

  /**
   * Writes the lowest point, along a direction, of the curved surface around a sample point. Only
   * shapes know their surface; for other tools that is the sample point itself. Points that do not
   * cover the surface stand for no more of it than the shape says.
   *
   * @param index the index of the sample point
   * @param up unit, tool frame
   * @param dest written, tool frame, mm
   * @return {@code dest}
   */
  public Vec3 lowestNear(int index, Vec3 up, Vec3 dest) {
    point(index, dest);
    double withinMm = isCovered() ? coverRadiusMm : 0;
    return solid == null ? dest : solid.lowestNear(dest, up, withinMm, dest);
  }

  /** {@return the tree of bounding spheres over the sample points} */
  public SphereTree tree() {
    return tree;
  }

  /** {@return the kinetic metric} */
  public KineticMetric metric() {
    return metric;
  }

  /** {@return an upper bound of the distance of any sample point from the reference point, mm} */
  public double radiusMm() {
    return radiusMm;
  }

  /** {@return the root mean square distance of the matter from the reference point, mm} */
  public double rmsRadiusMm() {
    return metric.rmsRadiusMm();
  }

  /**
   * {@return the cover radius, mm: each surface point of the tool lies within this distance of a
   * sample point} It is {@link #NOT_COVERED} for a thinned tool.
   */
  public double coverRadiusMm() {
    return coverRadiusMm;
  }

  /** {@return whether the sample points cover the surface, as the whole-tool theorem needs} */
  public boolean isCovered() {
    return coverRadiusMm < NOT_COVERED;
  }

  /** {@return the solid that the points were sampled from, or null if there is none} */
  public ToolSolid solid() {
    return solid;
  }

  /**
   * Writes the position of the reference point in the frame of the source: the world for a segment,
   * and the own frame of a shape or a mesh. A tool pose with this translation and no rotation puts
   * the tool where it was read.
   *
   * @param dest receives the position, mm
   * @return {@code dest}
   */
  public Vec3 referenceMm(Vec3 dest) {
    return dest.set(referenceMm);
  }

  /**
   * {@return a tool of fewer of these points, spread evenly, with the same matter} Its points no
   * longer cover the surface.
   *
   * @param most the largest number of points; if there are no more, this tool is returned
   * @throws IllegalArgumentException if {@code most} is below 1
   */
  public RigidTool thinned(int most) {
    if (most < 1) {
      throw new IllegalArgumentException("a tool needs at least one point: points=" + most);
    }
    if (most >= count()) {
      return this;
    }
    double[][] kept = new double[3][most];
    for (int n = 0; n < most; n++) {
      // Points that follow each other in the order of the tree are near each other in space.
      int from = (int) ((2L * n + 1) * count() / (2L * most));
      kept[0][n] = x[from];
      kept[1][n] = y[from];
      kept[2][n] = z[from];
    }
    return new RigidTool(kept, metric, NOT_COVERED, referenceMm, solid);
  }
}
