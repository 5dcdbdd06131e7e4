package org.palpate.io.format;

import org.palpate.io.volume.VolumeHeader.ValueRange;
import org.palpate.io.volume.VoxelType;

/**
 * Maps stored numbers to values: {@code stored * slope + intercept}.
 *
 * @param slope finite, not 0
 * @param intercept finite
 */
public record Scaling(double slope, double intercept) {
  public static final Scaling NONE = new Scaling(1, 0);

  /** Whether values are the stored numbers. */
  boolean isNone() {
    return slope == 1 && intercept == 0;
  }

  /** Returns the value of a stored number. */
  public double apply(double stored) {
    return stored * slope + intercept;
  }

  /** Returns the bounds on the values of a type after scaling. */
  public ValueRange range(VoxelType type) {
    if (isNone()) {
      return ValueRange.of(type);
    }
    double a = apply(type.low());
    double b = apply(type.high());
    double low = Math.min(a, b);
    double high = Math.max(a, b);
    boolean integer =
        type.fitsInt()
            && isInteger(slope)
            && isInteger(intercept)
            && low >= Integer.MIN_VALUE
            && high <= Integer.MAX_VALUE;
    return new ValueRange(low, high, integer);
  }

  private static boolean isInteger(double number) {
    return number == Math.rint(number) && Math.abs(number) <= Integer.MAX_VALUE;
  }
}
