package org.palpate.tool;

import org.palpate.io.file.NumberParser;
import org.palpate.io.volume.VolumeFormatException;

/**
 * The clearance that the user chose for a tool.
 *
 * @param wholeBody whether the solid of the tool keeps clear of bodies, rather than its points
 *     alone
 * @param marginMm the gap between the solids, mm; negative if they may overlap by that depth
 */
public record ClearanceChoice(boolean wholeBody, double marginMm) {
  /** Mode {@code points}: no leg of a point touches a solid. */
  public static final ClearanceChoice POINTS = new ClearanceChoice(false, 0);

  /** Mode {@code body}: the solids of tool and body do not overlap. */
  public static final ClearanceChoice BODY = new ClearanceChoice(true, 0);

  /**
   * Parses {@code points}, {@code body} or a margin in mm.
   *
   * @throws VolumeFormatException if the text is none of these
   */
  public static ClearanceChoice parse(String text) throws VolumeFormatException {
    String word = text.strip();
    if (word.equals("points")) {
      return POINTS;
    }
    if (word.equals("body")) {
      return BODY;
    }
    double marginMm = NumberParser.number(word);
    if (!(Math.abs(marginMm) <= ToolSpec.LONGEST_MM)) {
      throw new VolumeFormatException(
          "the clearance is not understood",
          "--clearance " + text,
          "write points, body, or a margin in mm, as in --clearance -0.5");
    }
    return new ClearanceChoice(true, marginMm);
  }
}
