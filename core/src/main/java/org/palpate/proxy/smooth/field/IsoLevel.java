package org.palpate.proxy.smooth.field;

import org.palpate.geometry.Vec3;

/**
 * The isosurface that the interaction point slides on, and the height above it that an occupancy
 * means.
 *
 * <p>The isosurface runs at a fixed offset outside the surface between solid and empty, so that
 * single voxels do not stand out of it. Its occupancy follows from the profile of the field across
 * a plane: the kernel is taken for a Gaussian a little wider than itself, which fits the middle of
 * its profile to 0.01 edges.
 */
public final class IsoLevel {
  /**
   * The offset as a fraction of half a voxel's diagonal. Voxels stand out of the surface that they
   * sample by at most that half, and the isosurface runs just beyond. It is nearer along axes where
   * the smoothing does not reach that far; there voxels stand out less as well.
   */
  private static final double OFFSET_FRACTION = 1.12;

  /** The distance of the isosurface from a plane of solid, outside it, if voxels are cubes. */
  public static final double OFFSET_OF_CUBES_EDGES = OFFSET_FRACTION * Math.sqrt(3) / 2;

  /** The offset, in standard deviations, of the level nearer to the solid. */
  private static final double NEAR_DEVIATIONS = 1.05;

  /** The width, over the kernel's, of the Gaussian whose profile is as steep in the middle. */
  private static final double MIDDLE_WIDENING = 1.04;

  private static final int TABLE_STEPS = 512;

  /** The table ends at this many standard deviations on either side. */
  private static final double MAX_DEVIATIONS = 2.5;

  private static final int BISECTIONS = 60;
  private static final int SERIES_TERMS = 60;

  /** The inverse of a Gaussian's upper tail, in standard deviations, at tails from 0 to 1. */
  private static final double[] DEVIATIONS = deviations();

  private final double varianceX;
  private final double varianceY;
  private final double varianceZ;
  private final boolean isotropic;
  private final double sigma;
  private final double meanVariance;

  /** The offset of a surface across each axis; between them it follows an ellipsoid. */
  private final double offsetX;

  private final double offsetY;
  private final double offsetZ;
  private final boolean isUniform;
  private final boolean isFar;
  private final double occupancy;

  /**
   * Creates the level for a field's smoothing.
   *
   * @param edges the edges of a voxel along x, y and z, in shortest edges
   * @param maxDeviations the greatest offset, in standard deviations of the smoothing; farther out
   *     the field would be nearly flat
   * @param farDeviations the offset beyond which the isosurface counts as far, see {@link #isFar}
   */
  IsoLevel(CoefficientSource source, Vec3 edges, double maxDeviations, double farDeviations) {
    varianceX = variance(source.sigmaEdges(0));
    varianceY = variance(source.sigmaEdges(1));
    varianceZ = variance(source.sigmaEdges(2));
    isotropic = varianceX == varianceY && varianceX == varianceZ;
    sigma = Math.sqrt(varianceX);
    meanVariance = (varianceX + varianceY + varianceZ) / (3 * MIDDLE_WIDENING * MIDDLE_WIDENING);
    double wanted = OFFSET_FRACTION * edges.length() / 2;
    offsetX = Math.min(wanted, maxDeviations * Math.sqrt(varianceX));
    offsetY = Math.min(wanted, maxDeviations * Math.sqrt(varianceY));
    offsetZ = Math.min(wanted, maxDeviations * Math.sqrt(varianceZ));
    isFar =
        offsetX > farDeviations * Math.sqrt(varianceX)
            || offsetY > farDeviations * Math.sqrt(varianceY)
            || offsetZ > farDeviations * Math.sqrt(varianceZ);
    isUniform = offsetX == offsetY && offsetX == offsetZ;
    occupancy = tail(offsetX / sigma);
  }

  private static double variance(double sigmaEdges) {
    return sigmaEdges * sigmaEdges * MIDDLE_WIDENING * MIDDLE_WIDENING;
  }

  /**
   * {@return the greatest distance of the isosurface from a plane of solid, outside it, in edges}
   */
  public double mostOffsetEdges() {
    return Math.max(offsetX, Math.max(offsetY, offsetZ));
  }

  /**
   * {@return the distance of the isosurface from a plane of solid, outside it, in edges}
   *
   * @param normal the outward unit normal of the plane, along the axes of the grid
   */
  public double offsetEdges(Vec3 normal) {
    if (isUniform) {
      return offsetX;
    }
    double x = offsetX * normal.x;
    double y = offsetY * normal.y;
    double z = offsetZ * normal.z;
    return Math.sqrt(x * x + y * y + z * z);
  }

  /**
   * {@return the occupancy on the isosurface where its normal has a direction}
   *
   * @param normal the outward unit normal, along the axes of the grid
   */
  public double occupancy(Vec3 normal) {
    return isotropic ? occupancy : tail(offsetEdges(normal) / sigma(normal));
  }

  /**
   * {@return whether the isosurface is so far from the solid that the field is nearly flat there,
   * and that directions are better found on the level nearer to the solid}
   */
  public boolean isFar() {
    return isFar;
  }

  /**
   * {@return how far the isosurface lies above the nearer level, in edges}
   *
   * @param normal the outward unit normal, along the axes of the grid
   */
  public double aboveNearLevelEdges(Vec3 normal) {
    return Math.max(0, offsetEdges(normal) - NEAR_DEVIATIONS * sigma(normal));
  }

  /**
   * {@return the occupancy on the nearer level where its normal has a direction}
   *
   * @param normal the outward unit normal, along the axes of the grid
   */
  public double nearOccupancy(Vec3 normal) {
    return tail(Math.min(NEAR_DEVIATIONS, offsetEdges(normal) / sigma(normal)));
  }

  /**
   * {@return the height above the isosurface, in edges, of a point of an occupancy: negative
   * inside, and a few edges at most either way}
   *
   * @param occupancyAtPoint the occupancy at the point; below 0 or above 1 it counts as 0 or 1
   * @param normal the outward unit normal, along the axes of the grid
   */
  public double heightEdges(double occupancyAtPoint, Vec3 normal) {
    double at = Math.max(0, Math.min(1, occupancyAtPoint)) * TABLE_STEPS;
    int step = Math.min(TABLE_STEPS - 1, (int) at);
    double deviation = DEVIATIONS[step] + (at - step) * (DEVIATIONS[step + 1] - DEVIATIONS[step]);
    return deviation * sigma(normal) - offsetEdges(normal);
  }

  /**
   * {@return how much closer the isosurface runs to a curved surface than to a plane, in edges}
   *
   * @param curvatureSum the sum of the principal curvatures, per edge, positive if convex
   */
  public double curvatureShiftEdges(double curvatureSum) {
    return 0.5 * meanVariance * curvatureSum;
  }

  /** Returns the standard deviation of the smoothing along a unit normal, in edges. */
  private double sigma(Vec3 normal) {
    if (isotropic) {
      return sigma;
    }
    return Math.sqrt(
        varianceX * normal.x * normal.x
            + varianceY * normal.y * normal.y
            + varianceZ * normal.z * normal.z);
  }

  /** Returns the Gaussian's upper tail beyond {@code t} deviations, as the table inverts it. */
  private static double tail(double t) {
    int low = 0;
    int high = TABLE_STEPS;
    while (high - low > 1) {
      int middle = (low + high) >>> 1;
      if (DEVIATIONS[middle] > t) {
        low = middle;
      } else {
        high = middle;
      }
    }
    double fraction = (DEVIATIONS[low] - t) / (DEVIATIONS[low] - DEVIATIONS[high]);
    return (low + fraction) / TABLE_STEPS;
  }

  private static double[] deviations() {
    double[] table = new double[TABLE_STEPS + 1];
    for (int step = 0; step <= TABLE_STEPS; step++) {
      table[step] = deviationAt(step / (double) TABLE_STEPS);
    }
    return table;
  }

  /** Returns the deviations beyond which the Gaussian has this tail, by bisection. */
  private static double deviationAt(double wantedTail) {
    double low = -MAX_DEVIATIONS;
    double high = MAX_DEVIATIONS;
    for (int n = 0; n < BISECTIONS; n++) {
      double middle = 0.5 * (low + high);
      if (exactTail(middle) > wantedTail) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /** Returns the Gaussian's upper tail beyond {@code t} deviations, by its power series. */
  private static double exactTail(double t) {
    double term = t;
    double sum = t;
    for (int n = 1; n < SERIES_TERMS; n++) {
      term *= t * t / (2 * n + 1);
      sum += term;
    }
    return 0.5 - sum * StrictMath.exp(-0.5 * t * t) / StrictMath.sqrt(2 * StrictMath.PI);
  }
}
