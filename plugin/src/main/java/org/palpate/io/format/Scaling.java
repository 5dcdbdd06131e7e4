package org.palpate.io.format;

import org.palpate.io.volume.VolumeHeader.ValueRange;
import org.palpate.io.volume.VoxelType;

/**
 * What makes a value of a stored number: {@code stored * slope + intercept}.
 *
 * @param slope finite, not 0
 * @param intercept finite
 */
public record Scaling(double slope, double intercept) {
  public static final Scaling NONE = new Scaling(1, 0);

  boolean isNone() {
    return slope == 1 && intercept == 0;
  }

  public double apply(double stored) {
    return stored * slope + intercept;
  }

  /** The bound on values of a type once scaled. */
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
