package org.palpate.rigid;

import org.palpate.geometry.Vec3;

/**
 * A rigid tool: the points that must not meet a solid, in the tool frame in mm, with the reference
 * point at the origin. Immutable; the arrays are shared with the solver and must not be written.
 */
public final class ToolPoints {
  /** Value of {@link #coverRadiusMm} if the points do not cover the surface between them. */
  public static final double NOT_COVERED = Double.POSITIVE_INFINITY;

  final double[] x;
  final double[] y;
  final double[] z;
  final SphereTree tree;
  final KineticMetric metric;

  private final double coverRadiusMm;
  private final double radiusMm;
  private final Vec3 referenceMm;
  private final ToolSolid solid;

  /**
   * Creates a tool; see {@link ToolSampler}, which makes the points.
   *
   * @param coverRadiusMm every surface point of the solid lies within this distance of a point
   * @param referenceMm the reference point in the frame of the source, mm
   * @param solid the solid that the points were sampled from, in the tool frame; null if it is not
   *     closed
   */
  ToolPoints(
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

  /** Returns the number of points. */
  public int count() {
    return x.length;
  }

  /** Writes a point, tool frame, mm. */
  public Vec3 point(int index, Vec3 dest) {
    return dest.set(x[index], y[index], z[index]);
  }

  /** Returns the largest distance of a point from the reference point, mm. */
  public double radiusMm() {
    return radiusMm;
  }

  /** Returns the root mean square distance of the matter from the reference point, mm. */
  public double rmsRadiusMm() {
    return metric.rmsRadiusMm();
  }

  /**
   * Returns the distance, mm, within which every surface point of the tool has a sample point, or
   * {@link #NOT_COVERED}. The whole-tool theorem holds for clearances above it.
   */
  public double coverRadiusMm() {
    return coverRadiusMm;
  }

  /** Returns the solid that the points were sampled from, or null if there is none. */
  public ToolSolid solid() {
    return solid;
  }

  /**
   * Writes the position of the reference point in the frame of the source: world mm for a segment,
   * the shape's frame for a primitive. With this translation and no rotation the tool lies where it
   * was read.
   */
  public Vec3 referenceMm(Vec3 dest) {
    return dest.set(referenceMm);
  }

  /**
   * Returns a tool of about {@code most} of these points, evenly spread: the same matter, but the
   * points no longer cover the surface.
   */
  public ToolPoints thinned(int most) {
    if (most < 1) {
      throw new IllegalArgumentException("a tool needs at least one point: points=" + most);
    }
    if (most >= count()) {
      return this;
    }
    double[][] kept = new double[3][most];
    for (int n = 0; n < most; n++) {
      int from = (int) ((2L * n + 1) * count() / (2L * most)); // neighbours in the tree are near
      kept[0][n] = x[from];
      kept[1][n] = y[from];
      kept[2][n] = z[from];
    }
    return new ToolPoints(kept, metric, NOT_COVERED, referenceMm, solid);
  }
}
