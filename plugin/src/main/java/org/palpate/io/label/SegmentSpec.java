package org.palpate.io.label;

import java.util.Arrays;
import org.palpate.io.file.NumberParser;
import org.palpate.io.volume.VolumeFormatException;

/**
 * Which voxels make a segment: a name and a rule for values. NaN is in none.
 *
 * @param name what the person calls it
 * @param rule how voxels are chosen
 * @param rgb colour for drawing, 0xRRGGBB, or {@link #ANY_COLOUR}
 */
public record SegmentSpec(String name, Rule rule, int rgb) {
  /** Whoever builds the segment chooses its colour. */
  public static final int ANY_COLOUR = -1;

  private static final String OPTION = "--segment ";

  /** How voxels are chosen by their values. */
  public sealed interface Rule {
    /** Whether a voxel of this value is inside. */
    boolean selects(double value);
  }

  /** Values from {@code low} to {@code high}, both inside. */
  public record Range(double low, double high) implements Rule {
    @Override
    public boolean selects(double value) {
      return value >= low && value <= high;
    }
  }

  /** Values other than 0. */
  public record Nonzero() implements Rule {
    @Override
    public boolean selects(double value) {
      return value < 0 || value > 0;
    }
  }

  /** Values that are one of some labels. */
  public static final class Labels implements Rule {
    private final long[] sorted;

    public Labels(long... labels) {
      sorted = labels.clone();
      Arrays.sort(sorted);
    }

    @Override
    public boolean selects(double value) {
      long label = (long) value;
      return label == value && Arrays.binarySearch(sorted, label) >= 0;
    }

    /** A copy, in rising order. */
    public long[] sorted() {
      return sorted.clone();
    }
  }

  /** Values from {@code low} on. */
  public static SegmentSpec atLeast(String name, double low) {
    return range(name, low, Double.POSITIVE_INFINITY);
  }

  /** Values from {@code low} to {@code high}, both inside. */
  public static SegmentSpec range(String name, double low, double high) {
    return new SegmentSpec(name, new Range(low, high), ANY_COLOUR);
  }

  /** Values that are one of the labels. */
  public static SegmentSpec labels(String name, long... labels) {
    return new SegmentSpec(name, new Labels(labels), ANY_COLOUR);
  }

  /** Values other than 0. */
  public static SegmentSpec nonzero(String name) {
    return new SegmentSpec(name, new Nonzero(), ANY_COLOUR);
  }

  /** The same in a colour, 0xRRGGBB. */
  public SegmentSpec withRgb(int colour) {
    return new SegmentSpec(name, rule, colour);
  }

  /**
   * Reads {@code bone=>=1500}, {@code soft=300..900}, {@code jaw=label:7}, {@code
   * jaws=label:7,8,12} or {@code all=nonzero}.
   *
   * @throws VolumeFormatException where it says something else
   */
  public static SegmentSpec parse(String text) throws VolumeFormatException {
    int equals = text.indexOf('=');
    String name = equals < 0 ? "" : text.substring(0, equals).strip();
    if (name.isEmpty()) {
      throw refusal("a segment needs a name", text);
    }
    String rule = text.substring(equals + 1).strip();
    if (rule.equals("nonzero")) {
      return nonzero(name);
    }
    if (rule.startsWith("label:")) {
      return labels(name, parseLabels(rule.substring(6), text));
    }
    return parseRange(name, rule, text);
  }

  private static long[] parseLabels(String list, String text) throws VolumeFormatException {
    try {
      return Arrays.stream(list.split(",", -1))
          .map(String::strip)
          .mapToLong(Long::parseLong)
          .toArray();
    } catch (NumberFormatException e) {
      throw refusal("labels must be whole numbers", text);
    }
  }

  private static SegmentSpec parseRange(String name, String rule, String text)
      throws VolumeFormatException {
    int dots = rule.indexOf("..");
    double low = Double.NaN;
    double high = Double.NaN;
    if (rule.startsWith(">=")) {
      low = NumberParser.number(rule.substring(2));
      high = Double.POSITIVE_INFINITY;
    } else if (dots > 0) {
      low = NumberParser.number(rule.substring(0, dots));
      high = NumberParser.number(rule.substring(dots + 2));
    }
    if (!(low <= high)) {
      throw refusal("the values of a segment are not understood", text);
    }
    return range(name, low, high);
  }

  private static VolumeFormatException refusal(String what, String text) {
    return new VolumeFormatException(
        what,
        OPTION + text,
        "write 'bone=>=1500', 'soft=300..900', 'jaw=label:7,8' or 'all=nonzero'");
  }
}
