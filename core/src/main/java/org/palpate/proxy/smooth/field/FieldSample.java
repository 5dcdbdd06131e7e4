package org.palpate.proxy.smooth.field;

import org.palpate.geometry.Vec3;

/**
 * The occupancy field at one point: value, gradient and Hessian, and the isosurface as seen from
 * there.
 *
 * <p>An {@link OccupancyField} owns its one sample and overwrites it in each evaluation; callers
 * only read. Derivatives are with respect to lengths in shortest voxel edges, along the axes of the
 * grid. The normal and the heights are computed when they are first asked for. Belongs to the
 * haptic thread; allocates nothing.
 */
public final class FieldSample {
  /** The greatest height that {@link #boundedHeightEdges} reports. */
  public static final double MAX_HEIGHT_EDGES = 2;

  /** Below this occupancy there is no surface near. */
  private static final double OPEN_OCCUPANCY = 0.02;

  /** A gradient shorter than this, per edge, has no meaningful direction. */
  private static final double MIN_SLOPE = 0.02;

  private static final long NEVER = -1;

  private final IsoLevel level;
  private long evaluation;
  private double occupancy;
  private double gx;
  private double gy;
  private double gz;
  private double hxx;
  private double hyy;
  private double hzz;
  private double hxy;
  private double hxz;
  private double hyz;

  /** The evaluation whose slope, and normal if it has one, stand in the fields below. */
  private long normalOf = NEVER;

  private final Vec3 normal = new Vec3();
  private double slope;
  private double inverseSlope;
  private double heightEdges;

  private long boundedHeightOf = NEVER;
  private double boundedHeightEdges;

  FieldSample(IsoLevel level) {
    this.level = level;
  }

  /**
   * {@return the number of the evaluation} It changes whenever any other value of the sample may
   * have changed.
   */
  public long evaluation() {
    return evaluation;
  }

  /** {@return the occupancy, about 0 to 1; beside wide terraces it may be a little less than 0} */
  public double occupancy() {
    return occupancy;
  }

  /** {@return the first derivative along x} */
  public double gx() {
    return gx;
  }

  /** {@return the first derivative along y} */
  public double gy() {
    return gy;
  }

  /** {@return the first derivative along z} */
  public double gz() {
    return gz;
  }

  /** {@return the second derivative along x} */
  public double hxx() {
    return hxx;
  }

  /** {@return the second derivative along y} */
  public double hyy() {
    return hyy;
  }

  /** {@return the second derivative along z} */
  public double hzz() {
    return hzz;
  }

  /** {@return the mixed derivative along x and y} */
  public double hxy() {
    return hxy;
  }

  /** {@return the mixed derivative along x and z} */
  public double hxz() {
    return hxz;
  }

  /** {@return the mixed derivative along y and z} */
  public double hyz() {
    return hyz;
  }

  /** {@return whether the point lies in open space, with no surface near} */
  public boolean isOpen() {
    return occupancy < OPEN_OCCUPANCY;
  }

  /** {@return whether the field is steep enough here for its gradient to mean a direction} */
  public boolean hasNormal() {
    if (normalOf != evaluation) {
      findNormal();
    }
    return slope >= MIN_SLOPE;
  }

  /** {@return the outward unit normal; valid only if {@link #hasNormal}, not to be changed} */
  public Vec3 normal() {
    return normal;
  }

  /** {@return the inverse of the gradient's length; valid only if {@link #hasNormal}} */
  public double inverseSlope() {
    return inverseSlope;
  }

  /**
   * {@return the height of the point above the isosurface, in edges, to first order along the
   * gradient; negative inside} Valid only if {@link #hasNormal}.
   */
  public double heightEdges() {
    return heightEdges;
  }

  private void findNormal() {
    normalOf = evaluation;
    slope = Math.sqrt(gx * gx + gy * gy + gz * gz);
    if (slope >= MIN_SLOPE) {
      inverseSlope = 1 / slope;
      normal.set(-gx * inverseSlope, -gy * inverseSlope, -gz * inverseSlope);
      heightEdges = (level.occupancy(normal) - occupancy) * inverseSlope;
    }
  }

  /**
   * {@return the height of the point above the isosurface, in edges, as the occupancy alone gives
   * it: bounded by {@link #MAX_HEIGHT_EDGES} above and by the isosurface's offset below} Without a
   * normal it is the upper bound in open space, and 0 elsewhere.
   */
  public double boundedHeightEdges() {
    if (boundedHeightOf != evaluation) {
      boundedHeightOf = evaluation;
      boundedHeightEdges = findBoundedHeight();
    }
    return boundedHeightEdges;
  }

  private double findBoundedHeight() {
    if (!hasNormal()) {
      return isOpen() ? MAX_HEIGHT_EDGES : 0;
    }
    double height = level.heightEdges(occupancy, normal);
    return Math.max(-level.offsetEdges(normal), Math.min(MAX_HEIGHT_EDGES, height));
  }

  /**
   * {@return the sum of the isosurface's principal curvatures, per edge; positive where it is
   * convex} Without a normal of its own the sample uses the last one that it had.
   */
  public double curvatureSum() {
    double alongNormal =
        normal.x * (hxx * normal.x + 2 * hxy * normal.y)
            + normal.y * (hyy * normal.y + 2 * hyz * normal.z)
            + normal.z * (hzz * normal.z + 2 * hxz * normal.x);
    return (alongNormal - hxx - hyy - hzz) * inverseSlope;
  }

  /** Begins another evaluation at zero. */
  void clear() {
    evaluation++;
    occupancy = gx = gy = gz = hxx = hyy = hzz = hxy = hxz = hyz = 0;
  }

  /**
   * Adds one layer of splines along z.
   *
   * @param layer 0, 1 or 2 for the layer below, at and above the nearest corner
   * @param w the point's z less the nearest corner's, from -0.5 to 0.5
   * @param f the layer's sum along x and y; the others are its derivatives
   */
  void addLayer(
      int layer, double w, double f, double fx, double fy, double fxx, double fxy, double fyy) {
    double weight;
    double slopeOfWeight;
    double bendOfWeight;
    if (layer == 1) {
      weight = 0.75 - w * w;
      slopeOfWeight = -2 * w;
      bendOfWeight = -2;
    } else {
      double side = layer - 1;
      weight = 0.5 * (0.5 + side * w) * (0.5 + side * w);
      slopeOfWeight = w + 0.5 * side;
      bendOfWeight = 1;
    }
    occupancy += f * weight;
    gx += fx * weight;
    gy += fy * weight;
    gz += f * slopeOfWeight;
    hxx += fxx * weight;
    hxy += fxy * weight;
    hyy += fyy * weight;
    hxz += fx * slopeOfWeight;
    hyz += fy * slopeOfWeight;
    hzz += f * bendOfWeight;
  }

  /** Turns derivatives per voxel into derivatives per shortest edge. */
  void scale(double inverseX, double inverseY, double inverseZ) {
    gx *= inverseX;
    gy *= inverseY;
    gz *= inverseZ;
    hxx *= inverseX * inverseX;
    hyy *= inverseY * inverseY;
    hzz *= inverseZ * inverseZ;
    hxy *= inverseX * inverseY;
    hxz *= inverseX * inverseZ;
    hyz *= inverseY * inverseZ;
  }
}
