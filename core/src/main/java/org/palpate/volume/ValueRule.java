package org.palpate.volume;

import java.util.Arrays;

/** Which values of a volume belong to a segment. NaN belongs to none. Immutable. */
public sealed interface ValueRule {

  /** Whether a voxel with this value, as the file gives it after rescaling, belongs. */
  boolean selects(double value);

  /** Every value from {@code low} up. */
  record AtLeast(double low) implements ValueRule {
    @Override
    public boolean selects(double value) {
      return value >= low;
    }
  }

  /** Every value from {@code low} to {@code high}, both included. */
  record Between(double low, double high) implements ValueRule {
    @Override
    public boolean selects(double value) {
      return value >= low && value <= high;
    }
  }

  /** Every value but zero. */
  record NonZero() implements ValueRule {
    @Override
    public boolean selects(double value) {
      return value < 0 || value > 0;
    }
  }

  /** The values of some labels, whole numbers. */
  final class OneOf implements ValueRule {
    private final long[] sortedLabels;

    public OneOf(long... labels) {
      sortedLabels = labels.clone();
      Arrays.sort(sortedLabels);
    }

    @Override
    public boolean selects(double value) {
      long label = (long) value;
      return label == value && Arrays.binarySearch(sortedLabels, label) >= 0;
    }

    /** The labels in rising order, a copy. */
    public long[] labels() {
      return sortedLabels.clone();
    }
  }
}
