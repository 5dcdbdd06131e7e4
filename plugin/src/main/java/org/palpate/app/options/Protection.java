package org.palpate.app.options;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.palpate.app.process.PalpateException;
import org.palpate.body.GrownSolids;
import org.palpate.force.EffectPlan;
import org.palpate.force.guide.GuideStrength;
import org.palpate.force.guide.Guides;
import org.palpate.force.guide.SegmentDistance;
import org.palpate.io.file.NumberParser;
import org.palpate.io.file.NumberText;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/**
 * A segment that is protected.
 *
 * @param name its name
 * @param marginMm the margin that is kept from it, mm
 * @param guideMm the width of the guidance outside the margin, mm
 */
record Protection(String name, double marginMm, double guideMm) {
  private static final double MOST_MM = 1000;

  /**
   * Reads the texts of an option.
   *
   * @throws PalpateException exit code 2, if one cannot be read
   */
  static List<Protection> all(List<String> texts) {
    List<Protection> found = new ArrayList<>();
    for (String text : texts) {
      Protection read = of(text);
      if (read.name.isEmpty() || !isLength(read.marginMm) || !isLength(read.guideMm)) {
        throw PalpateException.wrongUse(
            "the margin cannot be read",
            "--protect " + text,
            "write NAME, NAME:MM or NAME:MM:MM with lengths from 0 to 1,000 mm, as in nerve:1.5");
      }
      found.add(read);
    }
    return found;
  }

  /** Reads NAME, NAME:MM or NAME:MM:MM; a name may have colons. */
  private static Protection of(String text) {
    int last = text.lastIndexOf(':');
    double end = last < 0 ? 0 : NumberParser.number(text.substring(last + 1));
    String name = last < 0 ? text : text.substring(0, last);
    int before = name.lastIndexOf(':');
    double margin = before < 0 ? Double.NaN : NumberParser.number(name.substring(before + 1));
    return Double.isNaN(margin)
        ? new Protection(name, end, end)
        : new Protection(name.substring(0, before), margin, end);
  }

  private static boolean isLength(double mm) {
    return mm >= 0 && mm <= MOST_MM;
  }

  /**
   * Returns the push away from the margin; empty without guidance.
   *
   * @param segments all segments, of one grid
   * @throws PalpateException exit code 2, if there is no such segment, if the margin is too wide,
   *     or if the segment is too large for a push
   */
  Optional<EffectPlan> guidance(SegmentedVolume segments) {
    Segment segment = NamedSegment.of(segments, "--protect ", name, name);
    checkMargin(segments);
    return guideMm == 0 ? Optional.empty() : Optional.of(push(segment, segments.grid()));
  }

  private void checkMargin(SegmentedVolume segments) {
    double mostMm = GrownSolids.MOST_GROWTH_EDGES * segments.grid().metric().shortestEdgeMm();
    if (marginMm > mostMm) {
      throw PalpateException.wrongUse(
          "the margin is wider than " + NumberText.display(mostMm) + " mm, 64 voxels",
          "--protect " + name + ":" + NumberText.display(marginMm),
          "choose a smaller one");
    }
  }

  private EffectPlan push(Segment segment, VoxelGrid grid) {
    double outerMm = marginMm + guideMm;
    double voxels = SegmentDistance.voxelsFor(segment.bits(), grid, outerMm);
    if (voxels > SegmentDistance.MOST_VOXELS) {
      throw PalpateException.wrongUse(
          "the segment is too large for a guidance force",
          "--protect " + name,
          "end it with :0, as in " + name + ":1:0");
    }
    SegmentDistance distance = new SegmentDistance(segment.bits(), grid, outerMm);
    return Guides.away(distance, outerMm, GuideStrength.STANDARD);
  }
}
