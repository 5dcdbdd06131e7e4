package org.palpate.io.label;

import java.util.Arrays;
import org.palpate.io.label.SegmentSpec.Nonzero;
import org.palpate.io.label.SegmentSpec.Range;
import org.palpate.io.label.SegmentSpec.Rule;
import org.palpate.io.volume.VoxelSlice;

/** Classifies the voxels of a row as inside or outside a segment. */
@FunctionalInterface
interface RowClassifier {
  /** Sets {@code inside[n]} to 1 or 0 for {@code count} voxels from index {@code from} on. */
  void test(VoxelSlice slice, int from, int count, byte[] inside);

  /** Returns the classifier of a rule for slices of integers or of doubles. */
  static RowClassifier of(Rule rule, boolean integer) {
    if (rule instanceof Range range) {
      return integer ? integerRange(range.low(), range.high()) : range(range.low(), range.high());
    }
    if (rule instanceof Nonzero) {
      return integer ? RowClassifier::integerNonzero : RowClassifier::nonzero;
    }
    return (slice, from, count, inside) -> {
      for (int n = 0; n < count; n++) {
        inside[n] = (byte) (rule.selects(slice.value(from + n)) ? 1 : 0);
      }
    };
  }

  private static RowClassifier integerRange(double low, double high) {
    double lowest = Math.max(Math.ceil(low), Integer.MIN_VALUE);
    double highest = Math.min(Math.floor(high), Integer.MAX_VALUE);
    if (!(lowest <= highest)) {
      return (slice, from, count, inside) -> Arrays.fill(inside, 0, count, (byte) 0);
    }
    int bottom = (int) lowest;
    int top = (int) highest;
    return (slice, from, count, inside) -> {
      int[] values = slice.integers();
      for (int n = 0; n < count; n++) {
        int value = values[from + n];
        inside[n] = (byte) (value >= bottom && value <= top ? 1 : 0);
      }
    };
  }

  private static RowClassifier range(double low, double high) {
    return (slice, from, count, inside) -> {
      double[] values = slice.doubles();
      for (int n = 0; n < count; n++) {
        double value = values[from + n];
        inside[n] = (byte) (value >= low && value <= high ? 1 : 0);
      }
    };
  }

  private static void integerNonzero(VoxelSlice slice, int from, int count, byte[] inside) {
    int[] values = slice.integers();
    for (int n = 0; n < count; n++) {
      inside[n] = (byte) (values[from + n] != 0 ? 1 : 0);
    }
  }

  private static void nonzero(VoxelSlice slice, int from, int count, byte[] inside) {
    double[] values = slice.doubles();
    for (int n = 0; n < count; n++) {
      double value = values[from + n];
      inside[n] = (byte) (value < 0 || value > 0 ? 1 : 0);
    }
  }
}
