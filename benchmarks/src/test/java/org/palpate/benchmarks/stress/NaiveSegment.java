package org.palpate.benchmarks.stress;

import java.math.BigDecimal;
import org.palpate.raycast.Ray;
import org.palpate.volume.BitCube;

/**
 * Decides whether a segment touches a closed solid voxel by clipping it at the six planes of every
 * voxel of a grid, in exact fractions. The reference of the judges, which use separating planes.
 */
public final class NaiveSegment {
  private BigDecimal[] enter;
  private BigDecimal[] leave;

  private NaiveSegment() {}

  /** Whether a segment touches a solid voxel. */
  public static boolean touches(BitCube bits, Ray ray) {
    return touches(bits, ray, 0);
  }

  /**
   * Whether a segment touches a solid voxel that is larger by a margin on all sides.
   *
   * @param margin voxels; negative if each voxel is smaller
   */
  public static boolean touches(BitCube bits, Ray ray, double margin) {
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          if (bits.get(i, j, k) && new NaiveSegment().touches(ray, i, j, k, margin)) {
            return true;
          }
        }
      }
    }
    return false;
  }

  private boolean touches(Ray ray, int i, int j, int k, double margin) {
    enter = new BigDecimal[] {BigDecimal.ZERO, BigDecimal.ONE};
    leave = new BigDecimal[] {BigDecimal.ONE, BigDecimal.ONE};
    return clips(ray.fromX, ray.toX, i, margin)
        && clips(ray.fromY, ray.toY, j, margin)
        && clips(ray.fromZ, ray.toZ, k, margin);
  }

  /** Clips the part of the segment that is left; fractions are a numerator and a denominator. */
  private boolean clips(double from, double to, int cell, double margin) {
    BigDecimal along = new BigDecimal(to).subtract(new BigDecimal(from));
    BigDecimal toLow =
        BigDecimal.valueOf(cell).subtract(new BigDecimal(margin)).subtract(new BigDecimal(from));
    BigDecimal toHigh =
        BigDecimal.valueOf(cell + 1L).add(new BigDecimal(margin)).subtract(new BigDecimal(from));
    if (along.signum() == 0) {
      return toLow.signum() <= 0 && toHigh.signum() >= 0;
    }
    boolean forward = along.signum() > 0;
    BigDecimal[] first = forward ? fraction(toLow, along) : fraction(toHigh, along);
    BigDecimal[] second = forward ? fraction(toHigh, along) : fraction(toLow, along);
    enter = compare(first, enter) > 0 ? first : enter;
    leave = compare(second, leave) < 0 ? second : leave;
    return compare(enter, leave) <= 0;
  }

  private static BigDecimal[] fraction(BigDecimal numerator, BigDecimal denominator) {
    return denominator.signum() > 0
        ? new BigDecimal[] {numerator, denominator}
        : new BigDecimal[] {numerator.negate(), denominator.negate()};
  }

  private static int compare(BigDecimal[] a, BigDecimal[] b) {
    return a[0].multiply(b[1]).compareTo(b[0].multiply(a[1]));
  }
}
