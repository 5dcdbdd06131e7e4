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
 * Surveys every value of a volume while it is read: the extremes, whether values are labels or
 * intensities, and good thresholds. Keeps counts, no values.
 */
public final class ValueStatistics implements SliceSink {
  /** The most distinct values that labels can have. */
  private static final int MAX_LABELS = 1024;

  /**
   * The least fraction of a label's voxels that the same label follows along x. Labels fill
   * regions, while intensities vary inside them. The label with the median fraction must reach it.
   */
  private static final double MIN_FLAT_FRACTION = 0.4;

  private static final int BINS = 1 << 16;

  /** The least fraction of the voxels that are air, and that are soft tissue, in a CT scan. */
  private static final double MIN_CT_FRACTION = 0.01;

  /** The largest fraction of voxels below air; scanners fill the corners with such values. */
  private static final double MAX_PADDING_FRACTION = 0.5;

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

  /** Counts the voxels of a value, and those whose successor along x has the same value. */
  private static final class Count {
    long voxels;
    long followed;

    double flatFraction() {
      return (double) followed / voxels;
    }
  }

  /** Creates a survey of the volume with this header. */
  public ValueStatistics(VolumeHeader header) {
    this(header.values(), header.labels());
  }

  private ValueStatistics(VolumeHeader.ValueRange range, Optional<LabelTable> table) {
    this.table = table;
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
      double value = slice.value(n) + 0.0; // turns -0.0 into 0
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
   * Returns one of 65,536 bins, which preserve the order of doubles: sign, exponent and top of the
   * mantissa.
   */
  private static int bin(double value) {
    int bits = Float.floatToRawIntBits((float) value) >>> 16;
    return (bits & 0x8000) != 0 ? ~bits & 0xffff : bits | 0x8000;
  }

  private static double binValue(int bin) {
    int bits = (bin & 0x8000) != 0 ? bin & 0x7fff : ~bin & 0xffff;
    return Float.intBitsToFloat(bits << 16);
  }

  /** Returns the result after the last slice. */
  public Summary summary() {
    if (exact) {
      collectExact();
    }
    return new Summary(low, high, notFinite, labels(), thresholds(), isHounsfield());
  }

  /**
   * Whether the values look like Hounsfield units: a part lies near air, a part near water, some
   * are as dense as bone, and none is beyond what scanners store.
   */
  private boolean isHounsfield() {
    double all = 0;
    double padding = 0;
    double air = 0;
    double tissue = 0;
    for (int n = 0; n < BINS; n++) {
      double value = exact ? (double) n + exactLow : binValue(n);
      all += bins[n];
      padding += value < -1100 ? bins[n] : 0;
      air += value >= -1100 && value <= -900 ? bins[n] : 0;
      tissue += value >= -200 && value <= 200 ? bins[n] : 0;
    }
    return low >= Short.MIN_VALUE
        && low <= -900
        && high >= 300
        && high <= Short.MAX_VALUE
        && padding <= MAX_PADDING_FRACTION * all
        && air >= MIN_CT_FRACTION * all
        && tissue >= MIN_CT_FRACTION * all;
  }

  /** Returns the statistics of a sample of single values, without labels. */
  public static Summary ofSample(double[] values) {
    ValueStatistics statistics =
        new ValueStatistics(
            new VolumeHeader.ValueRange(-Double.MAX_VALUE, Double.MAX_VALUE, false),
            Optional.empty());
    for (double value : values) {
      if (Double.isFinite(value)) {
        statistics.bins[bin(value + 0.0)]++;
        statistics.count(value + 0.0, false);
      }
    }
    return statistics.summary();
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
      // the background of a mask without 0 is its lower value
      return labels.subList(labels.size() == 2 ? 1 : 0, labels.size());
    }
    return isTableOf(labels) || (low >= 0 && isFlat()) ? labels : List.of();
  }

  /** Whether the table names every label; a table without names declares all values labels. */
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
   * The result of a survey.
   *
   * @param low the least finite value; infinity if there is none
   * @param high the largest finite value
   * @param notFinite how many values are NaN or infinite
   * @param labels the labels of a mask or a label volume, without background; empty for intensities
   * @param thresholds two values that separate intensities, ascending; empty if there are fewer
   *     than three values
   * @param hounsfield whether the values look like Hounsfield units of a CT scan
   */
  public record Summary(
      double low,
      double high,
      long notFinite,
      List<Long> labels,
      List<Double> thresholds,
      boolean hounsfield) {
    /** Copies the lists. */
    public Summary {
      labels = List.copyOf(labels);
      thresholds = List.copyOf(thresholds);
    }
  }
}
