package org.palpate.io.label;

import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import org.palpate.io.file.NumberParser;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.VolumeFormatException;

/**
 * The specification of a segment: a name and a rule for voxel values. NaN is in no segment.
 *
 * @param name the name that the user gives
 * @param rule selects voxels
 * @param rgb colour, 0xRRGGBB, or {@link #ANY_COLOUR}
 */
public record SegmentSpec(String name, Rule rule, int rgb) {
  /** Leaves the choice of a colour to the builder of the segment. */
  public static final int ANY_COLOUR = -1;

  private static final String OPTION = "--segment ";

  /** Selects voxels by their values. */
  public sealed interface Rule {
    /** Whether a voxel of this value is inside. */
    boolean selects(double value);
  }

  /** Selects values from {@code low} to {@code high}, both included. */
  public record Range(double low, double high) implements Rule {
    @Override
    public boolean selects(double value) {
      return value >= low && value <= high;
    }
  }

  /** Selects values other than 0. */
  public record Nonzero() implements Rule {
    @Override
    public boolean selects(double value) {
      return value < 0 || value > 0;
    }
  }

  /**
   * Selects the labels that a table gives a name. {@link #resolved} makes labels of it.
   *
   * @param name the name in the table
   */
  public record Named(String name) implements Rule {
    @Override
    public boolean selects(double value) {
      throw new IllegalStateException("name:" + name + " is not resolved");
    }
  }

  /** Selects values that are in a list of labels. */
  public static final class Labels implements Rule {
    private final long[] sorted;

    /** Creates the rule; copies the labels. */
    public Labels(long... labels) {
      sorted = labels.clone();
      Arrays.sort(sorted);
    }

    @Override
    public boolean selects(double value) {
      long label = (long) value;
      return label == value && Arrays.binarySearch(sorted, label) >= 0;
    }

    /** Returns a copy of the labels, ascending. */
    public long[] sorted() {
      return sorted.clone();
    }
  }

  /** Returns a segment of the values from {@code low} on. */
  public static SegmentSpec atLeast(String name, double low) {
    return range(name, low, Double.POSITIVE_INFINITY);
  }

  /** Returns a segment of the values from {@code low} to {@code high}, both included. */
  public static SegmentSpec range(String name, double low, double high) {
    return new SegmentSpec(name, new Range(low, high), ANY_COLOUR);
  }

  /** Returns a segment of the values in a list of labels. */
  public static SegmentSpec labels(String name, long... labels) {
    return new SegmentSpec(name, new Labels(labels), ANY_COLOUR);
  }

  /** Returns a segment of the values other than 0. */
  public static SegmentSpec nonzero(String name) {
    return new SegmentSpec(name, new Nonzero(), ANY_COLOUR);
  }

  /**
   * Returns this specification with the labels of a table instead of a name.
   *
   * @throws VolumeFormatException if the table is absent or has no label of this name
   */
  public SegmentSpec resolved(Optional<LabelTable> table) throws VolumeFormatException {
    if (!(rule instanceof Named named)) {
      return this;
    }
    Map<Long, LabelTable.Label> labels = table.map(LabelTable::labels).orElse(Map.of());
    long[] found =
        labels.entrySet().stream()
            .filter(entry -> entry.getValue().name().equals(named.name()))
            .mapToLong(Map.Entry::getKey)
            .toArray();
    if (found.length == 0) {
      throw new VolumeFormatException(
          labels.isEmpty() ? "the volume names no label" : "the volume has no label of this name",
          OPTION + name + "=name:" + named.name(),
          "choose one that palpate info prints, or write label:7");
    }
    return new SegmentSpec(name, new Labels(found), rgb);
  }

  /** Returns this specification with a colour, 0xRRGGBB. */
  public SegmentSpec withRgb(int colour) {
    return new SegmentSpec(name, rule, colour);
  }

  /**
   * Parses {@code bone=>=1500}, {@code soft=300..900}, {@code jaw=label:7}, {@code
   * jaws=label:7,8,12}, {@code jaw=name:Mandible} or {@code all=nonzero}.
   *
   * @throws VolumeFormatException if the text has another form
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
    if (rule.startsWith("name:") && !rule.substring(5).isBlank()) {
      return new SegmentSpec(name, new Named(rule.substring(5).strip()), ANY_COLOUR);
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
      throw refusal("labels must be integers", text);
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
      throw refusal("the values of the segment are not understood", text);
    }
    return range(name, low, high);
  }

  private static VolumeFormatException refusal(String what, String text) {
    return new VolumeFormatException(
        what,
        OPTION + text,
        "write 'bone=>=1500', 'soft=300..900', 'jaw=label:7,8', 'jaw=name:Mandible' or"
            + " 'all=nonzero'");
  }
}
