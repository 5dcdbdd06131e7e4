package org.palpate.tool;

import java.util.Optional;
import java.util.OptionalInt;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.VolumeFormatException;

/**
 * The tool that a user asked for.
 *
 * @param spec what it is made from
 * @param segment the voxels of a volume file that are the tool; all values but 0 if empty
 * @param points the most sample points of the tool; all that there are if empty
 * @param clearance the clearance; if empty, {@code points} for an open mesh and for a tool with a
 *     given number of points, and else {@code body}
 */
public record ToolRequest(
    ToolSpec spec,
    Optional<SegmentSpec> segment,
    OptionalInt points,
    Optional<ClearanceChoice> clearance) {

  /** Returns the request of a tool with the defaults of its kind. */
  public static ToolRequest of(ToolSpec spec) {
    return new ToolRequest(spec, Optional.empty(), OptionalInt.empty(), Optional.empty());
  }

  /**
   * Parses the values of the options of a tool; null for one that was not given.
   *
   * @throws VolumeFormatException if a value is not understood or does not fit the tool
   */
  public static ToolRequest parse(String tool, String segment, Integer points, String clearance)
      throws VolumeFormatException {
    ToolRequest request =
        new ToolRequest(
            ToolSpec.parse(tool),
            segment == null ? Optional.empty() : Optional.of(parseSegment(segment)),
            points == null ? OptionalInt.empty() : OptionalInt.of(points),
            clearance == null ? Optional.empty() : Optional.of(ClearanceChoice.parse(clearance)));
    request.check(tool, segment, points, clearance);
    return request;
  }

  private static SegmentSpec parseSegment(String text) throws VolumeFormatException {
    try {
      return SegmentSpec.parse(text);
    } catch (VolumeFormatException e) {
      throw new VolumeFormatException(
          "the voxels of the tool are not understood",
          "--tool-segment " + text,
          "write 'tool=nonzero', 'tool=>=1500', 'tool=300..900' or 'tool=label:7,8'",
          e);
    }
  }

  private void check(String tool, String segmentText, Integer count, String clearanceText)
      throws VolumeFormatException {
    if (spec instanceof ToolSpec.Point) {
      requireNone("--tool-segment", segmentText);
      requireNone("--points", count);
    }
    if (segment.isPresent() && !(spec instanceof ToolSpec.VolumeFile)) {
      throw new VolumeFormatException(
          "only a volume file has segments",
          "--tool-segment " + segmentText + " with --tool " + tool,
          "name a volume file with --tool, or leave --tool-segment out");
    }
    if (count != null && count < 1) {
      throw new VolumeFormatException(
          "a tool needs at least one point", "--points " + count, "give a number from 1 on");
    }
    if (count != null && clearance.isPresent() && clearance.get().wholeBody()) {
      throw new VolumeFormatException(
          "a tool with fewer points has no clearance as a whole",
          "--points " + count + " with --clearance " + clearanceText,
          "leave --points out, or write --clearance points");
    }
  }

  private static void requireNone(String option, Object value) throws VolumeFormatException {
    if (value != null) {
      throw new VolumeFormatException(
          "a single point has no shape",
          option + " " + value,
          "choose a tool with --tool, for example --tool sphere:4, or leave " + option + " out");
    }
  }
}
