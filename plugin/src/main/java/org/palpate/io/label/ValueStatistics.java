package org.palpate.io.label;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.SliceSink;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VoxelSlice;

/**
 * Looks at every value of a volume while it is read: the least and the largest, whether they are
 * labels or intensities, and which thresholds part them well. Keeps counts, never values.
 */
public final class ValueStatistics implements SliceSink {
  /** More different values than this are no labels. */
  public static final int MAX_LABELS = 1024;

  /**
   * Of the voxels of a label, the share that is followed along x by one of the same: labels fill
   * regions, intensities vary inside them. Held by the label in the middle of all.
   */
  private static final double MIN_FLAT_FRACTION = 0.4;

  private static final int BINS = 1 << 16;

  private final Optional<LabelTable> table;
  private final boolean exact;
  private final int exactLow;
  private final long[] bins = new long[BINS];
  private final long[] followed = new long[BINS];
  private final Map<Double, Count> counts = new TreeMap<>();
  private Count lastCount = new Count();
  private double lastValue = Double.NaN;
  private double low = Double.POSITIVE_INFINITY;
  private double high = Double.NEGATIVE_INFINITY;
  private long notFinite;

  /** How often a value came, and how often its like followed it along x. */
  private static final class Count {
    long voxels;
    long followed;

    double flatFraction() {
      return (double) followed / voxels;
    }
  }

  /** A survey of a volume with this header. */
  public ValueStatistics(VolumeHeader header) {
    VolumeHeader.ValueRange range = header.values();
    table = header.labels();
    exact = range.isInteger() && range.high() - range.low() < BINS;
    exactLow = exact ? (int) range.low() : 0;
  }

  @Override
  public void accept(int k, VoxelSlice slice) {
    for (int j = 0; j < slice.sizeY(); j++) {
      if (exact) {
        countExactRow(slice.integers(), j * slice.sizeX(), slice.sizeX());
      } else {
        countRow(slice, j * slice.sizeX());
      }
    }
  }

  private void countExactRow(int[] values, int from, int count) {
    int before = values[from] - exactLow;
    bins[before]++;
    for (int n = from + 1; n < from + count; n++) {
      int value = values[n] - exactLow;
      bins[value]++;
      if (value == before) {
        followed[value]++;
      }
      before = value;
    }
  }

  private void countRow(VoxelSlice slice, int from) {
    double before = Double.NaN;
    for (int n = from; n < from + slice.sizeX(); n++) {
      double value = slice.value(n) + 0.0; // -0.0 is 0
      if (Double.isFinite(value)) {
        bins[bin(value)]++;
        count(value, value == before);
      } else {
        notFinite++;
      }
      before = value;
    }
  }

  private void count(double value, boolean follows) {
    if (value != lastValue) {
      lastValue = value;
      low = Math.min(low, value);
      high = Math.max(high, value);
      if (counts.size() <= MAX_LABELS) {
        lastCount = counts.computeIfAbsent(value, any -> new Count());
      }
    }
    lastCount.voxels++;
    lastCount.followed += follows ? 1 : 0;
  }

  /**
   * A bin for each of 65,536 ranges of doubles, in their order: sign, exponent, top of mantissa.
   */
  private static int bin(double value) {
    int bits = Float.floatToRawIntBits((float) value) >>> 16;
    return (bits & 0x8000) != 0 ? ~bits & 0xffff : bits | 0x8000;
  }

  private static double binValue(int bin) {
    int bits = (bin & 0x8000) != 0 ? bin & 0x7fff : ~bin & 0xffff;
    return Float.intBitsToFloat(bits << 16);
  }

  /** What was found, once every slice was taken. */
  public Summary summary() {
    if (exact) {
      collectExact();
    }
    return new Summary(low, high, notFinite, labels(), thresholds());
  }

  private void collectExact() {
    for (int n = 0; n < BINS; n++) {
      if (bins[n] > 0) {
        double value = (double) n + exactLow;
        low = Math.min(low, value);
        high = Math.max(high, value);
        Count count = new Count();
        count.voxels = bins[n];
        count.followed = followed[n];
        counts.put(value, count);
      }
    }
  }

  private List<Long> labels() {
    boolean mayBeLabels =
        counts.size() <= MAX_LABELS
            && counts.keySet().stream().allMatch(ValueStatistics::isInteger);
    if (!mayBeLabels) {
      return List.of();
    }
    List<Long> labels = new ArrayList<>();
    counts.keySet().stream()
        .filter(value -> value != 0)
        .forEach(value -> labels.add(value.longValue()));
    if (counts.size() <= 2 && !isNamed(labels)) {
      // a mask without 0 has its lower value as background
      return labels.subList(labels.size() == 2 ? 1 : 0, labels.size());
    }
    return isTableOf(labels) || (low >= 0 && isFlat()) ? labels : List.of();
  }

  /** Whether the table has every label; one without names says that all values are labels. */
  private boolean isTableOf(List<Long> labels) {
    return table.isPresent() && (table.get().labels().isEmpty() || isNamed(labels));
  }

  private boolean isNamed(List<Long> labels) {
    return table.isPresent() && table.get().labels().keySet().containsAll(labels);
  }

  private static boolean isInteger(double value) {
    return value == Math.rint(value) && Math.abs(value) < 0x1p53;
  }

  private boolean isFlat() {
    double[] fractions =
        counts.entrySet().stream()
            .filter(entry -> entry.getKey() != 0)
            .mapToDouble(entry -> entry.getValue().flatFraction())
            .sorted()
            .toArray();
    return fractions[fractions.length / 2] >= MIN_FLAT_FRACTION;
  }

  private List<Double> thresholds() {
    List<double[]> histogram = new ArrayList<>();
    for (int n = 0; n < BINS; n++) {
      if (bins[n] > 0) {
        histogram.add(new double[] {exact ? (double) n + exactLow : binValue(n), bins[n]});
      }
    }
    return OtsuThresholds.of(histogram);
  }

  /**
   * What a survey found.
   *
   * @param low the least finite value; infinity where there is none
   * @param high the largest finite value
   * @param notFinite how many values are NaN or infinite
   * @param labels the labels of a mask or a label volume, without background; empty for intensities
   * @param thresholds two values that part intensities well, rising; empty where there are fewer
   *     than three values
   */
  public record Summary(
      double low, double high, long notFinite, List<Long> labels, List<Double> thresholds) {
    /** Copies the lists. */
    public Summary {
      labels = List.copyOf(labels);
      thresholds = List.copyOf(thresholds);
    }
  }
}
