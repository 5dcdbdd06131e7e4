package org.palpate.proxy.smooth.field;

import org.palpate.geometry.Vec3;

/**
 * What a share of solid says about height over the surface between solid and empty, and which share
 * the level has that the point slides on. The kernel is taken for a Gaussian a little wider than it
 * is, which fits its middle to 0.01 edges.
 */
public final class IsoLevel {
  /**
   * How far the level runs outside the surface, as a share of half a voxel's diagonal: voxels stand
   * out of the surface that they sample by up to that half, and the level runs just beyond.
   */
  private static final double HEIGHT_SHARE = 1.12;

  /** How much wider than the kernel the Gaussian is whose middle is as steep. */
  private static final double MIDDLE_WIDENING = 1.04;

  private static final int TABLE_STEPS = 512;

  private static final double MOST_DEVIATIONS = 2.5;

  /** Deviations at shares 0 to 1 of a Gaussian, from plus to minus {@link #MOST_DEVIATIONS}. */
  private static final double[] DEVIATIONS = deviations();

  private final double varianceX;
  private final double varianceY;
  private final double varianceZ;
  private final boolean alike;
  private final double sigma;
  private final double bendVariance;
  private final double heightEdges;
  private final double share;

  /**
   * The level for a field's smoothing.
   *
   * @param edges edges of a voxel, in shortest edges
   */
  public IsoLevel(CoefficientSource source, Vec3 edges) {
    varianceX = variance(source.sigmaEdges(0));
    varianceY = variance(source.sigmaEdges(1));
    varianceZ = variance(source.sigmaEdges(2));
    alike = varianceX == varianceY && varianceX == varianceZ;
    sigma = Math.sqrt(varianceX);
    bendVariance = (varianceX + varianceY + varianceZ) / (3 * MIDDLE_WIDENING * MIDDLE_WIDENING);
    heightEdges = HEIGHT_SHARE * edges.length() / 2;
    share = shareAt(heightEdges / sigma);
  }

  private static double variance(double sigmaEdges) {
    return sigmaEdges * sigmaEdges * MIDDLE_WIDENING * MIDDLE_WIDENING;
  }

  /** How far the level runs outside a plane of solid, in shortest edges. */
  public double heightEdges() {
    return heightEdges;
  }

  /** The share of solid on the level where its unit normal is {@code normal}. */
  public double share(Vec3 normal) {
    return alike ? share : shareAt(heightEdges / sigma(normal));
  }

  /**
   * How far a point with this share lies over the level, edges: negative inside it, and no more
   * than a few edges either way.
   */
  public double over(double shareOfSolid, Vec3 normal) {
    double at = Math.max(0, Math.min(1, shareOfSolid)) * TABLE_STEPS;
    int step = Math.min(TABLE_STEPS - 1, (int) at);
    double deviation = DEVIATIONS[step] + (at - step) * (DEVIATIONS[step + 1] - DEVIATIONS[step]);
    return deviation * sigma(normal) - heightEdges;
  }

  /** How much nearer the level runs to a surface of this mean curvature than to a plane, edges. */
  public double nearerWhereBent(double sumOfCurvatures) {
    return 0.5 * bendVariance * sumOfCurvatures;
  }

  private double sigma(Vec3 normal) {
    if (alike) {
      return sigma;
    }
    return Math.sqrt(
        varianceX * normal.x * normal.x
            + varianceY * normal.y * normal.y
            + varianceZ * normal.z * normal.z);
  }

  /** The share of a Gaussian beyond {@code t} standard deviations, by the same table. */
  private static double shareAt(double t) {
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
    double part = (DEVIATIONS[low] - t) / (DEVIATIONS[low] - DEVIATIONS[high]);
    return (low + part) / TABLE_STEPS;
  }

  private static double[] deviations() {
    double[] table = new double[TABLE_STEPS + 1];
    for (int step = 0; step <= TABLE_STEPS; step++) {
      table[step] = deviationAt(step / (double) TABLE_STEPS);
    }
    return table;
  }

  /** Where a Gaussian has this share beyond, by halving; the ends are cut off. */
  private static double deviationAt(double shareBeyond) {
    double low = -MOST_DEVIATIONS;
    double high = MOST_DEVIATIONS;
    for (int n = 0; n < 60; n++) {
      double middle = 0.5 * (low + high);
      if (beyond(middle) > shareBeyond) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /** The share of a Gaussian beyond {@code t}, by its series. */
  private static double beyond(double t) {
    double term = t;
    double sum = t;
    for (int n = 1; n < 60; n++) {
      term *= t * t / (2 * n + 1);
      sum += term;
    }
    return 0.5 - sum * StrictMath.exp(-0.5 * t * t) / StrictMath.sqrt(2 * StrictMath.PI);
  }
}
