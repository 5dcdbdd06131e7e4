package org.palpate.testing;

import java.math.BigDecimal;
import org.palpate.raycast.Ray;
import org.palpate.volume.BitCube;

/**
 * Decides in rational arithmetic whether a segment between two doubles touches a closed voxel. It
 * clips the parameter interval of the segment by the three slabs of the voxel.
 *
 * <p>It is slow and simple, and shares no code and no method with the ray casters that it checks.
 */
public final class ExactOracle {
  private ExactOracle() {}

  /** A rational number; the denominator is positive. */
  record Rational(BigDecimal numerator, BigDecimal denominator) implements Comparable<Rational> {
    static final Rational ZERO = new Rational(BigDecimal.ZERO, BigDecimal.ONE);
    static final Rational ONE = new Rational(BigDecimal.ONE, BigDecimal.ONE);

    static Rational of(BigDecimal numerator, BigDecimal denominator) {
      return denominator.signum() < 0
          ? new Rational(numerator.negate(), denominator.negate())
          : new Rational(numerator, denominator);
    }

    @Override
    public int compareTo(Rational other) {
      return numerator.multiply(other.denominator).compareTo(other.numerator.multiply(denominator));
    }

    double toDouble() {
      return numerator.divide(denominator, new java.math.MathContext(40)).doubleValue();
    }
  }

  /** Returns the parameter at which the segment enters the closed voxel, or null if it misses. */
  private static Rational entry(Ray ray, int i, int j, int k) {
    Rational[] interval = {Rational.ZERO, Rational.ONE};
    boolean touches =
        clip(interval, ray.fromX, ray.toX, i)
            && clip(interval, ray.fromY, ray.toY, j)
            && clip(interval, ray.fromZ, ray.toZ, k);
    return touches ? interval[0] : null;
  }

  private static boolean clip(Rational[] interval, double from, double to, int cell) {
    BigDecimal start = new BigDecimal(from);
    BigDecimal delta = new BigDecimal(to).subtract(start);
    BigDecimal low = BigDecimal.valueOf(cell).subtract(start);
    BigDecimal high = low.add(BigDecimal.ONE);
    if (delta.signum() == 0) {
      return low.signum() <= 0 && high.signum() >= 0;
    }
    Rational atLow = Rational.of(low, delta);
    Rational atHigh = Rational.of(high, delta);
    Rational in = delta.signum() > 0 ? atLow : atHigh;
    Rational out = delta.signum() > 0 ? atHigh : atLow;
    interval[0] = in.compareTo(interval[0]) > 0 ? in : interval[0];
    interval[1] = out.compareTo(interval[1]) < 0 ? out : interval[1];
    return interval[0].compareTo(interval[1]) <= 0;
  }

  /** Whether the segment touches the closed voxel (i,j,k). */
  public static boolean touches(Ray ray, int i, int j, int k) {
    return overlaps(ray, i, j, k) && entry(ray, i, j, k) != null;
  }

  /**
   * Returns the parameter at which the segment enters the voxel, correctly rounded; NaN if it does
   * not touch it.
   */
  public static double entryParameter(Ray ray, int i, int j, int k) {
    Rational entry = entry(ray, i, j, k);
    return entry == null ? Double.NaN : entry.toDouble();
  }

  /**
   * Returns the parameter at which the segment first touches a solid voxel, correctly rounded; NaN
   * if it touches none. It visits every voxel in the segment's box.
   */
  public static double firstTouch(BitCube bits, Ray ray) {
    Rational first = null;
    for (int k = low(ray.fromZ, ray.toZ); k <= high(ray.fromZ, ray.toZ, bits.sizeZ()); k++) {
      for (int j = low(ray.fromY, ray.toY); j <= high(ray.fromY, ray.toY, bits.sizeY()); j++) {
        for (int i = low(ray.fromX, ray.toX); i <= high(ray.fromX, ray.toX, bits.sizeX()); i++) {
          Rational entry = bits.get(i, j, k) && overlaps(ray, i, j, k) ? entry(ray, i, j, k) : null;
          if (entry != null && (first == null || entry.compareTo(first) < 0)) {
            first = entry;
          }
        }
      }
    }
    return first == null ? Double.NaN : first.toDouble();
  }

  /** Whether the segment touches any solid voxel. */
  public static boolean touchesAny(BitCube bits, Ray ray) {
    for (int k = low(ray.fromZ, ray.toZ); k <= high(ray.fromZ, ray.toZ, bits.sizeZ()); k++) {
      for (int j = low(ray.fromY, ray.toY); j <= high(ray.fromY, ray.toY, bits.sizeY()); j++) {
        for (int i = low(ray.fromX, ray.toX); i <= high(ray.fromX, ray.toX, bits.sizeX()); i++) {
          if (bits.get(i, j, k) && touches(ray, i, j, k)) {
            return true;
          }
        }
      }
    }
    return false;
  }

  /** Whether the bounding boxes of segment and voxel touch. Exact. */
  private static boolean overlaps(Ray ray, int i, int j, int k) {
    return overlaps(ray.fromX, ray.toX, i)
        && overlaps(ray.fromY, ray.toY, j)
        && overlaps(ray.fromZ, ray.toZ, k);
  }

  private static boolean overlaps(double from, double to, int cell) {
    return Math.min(from, to) <= cell + 1.0 && Math.max(from, to) >= cell;
  }

  private static int low(double from, double to) {
    return (int) Math.max(0, Math.floor(Math.min(from, to)) - 1);
  }

  private static int high(double from, double to, int size) {
    return (int) Math.min(size - 1, Math.floor(Math.max(from, to)));
  }
}
