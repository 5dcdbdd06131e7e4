package org.palpate.io.label;

import java.util.List;

/**
 * A segment that is proposed for intensities, with the reason.
 *
 * @param name name of the segment
 * @param atLeast least value of its voxels
 * @param isExact whether the value is meant as it is; otherwise it may be rounded
 */
public record SegmentProposal(String name, double atLeast, boolean isExact) {
  /** The least value of bone in Hounsfield units; cancellous bone begins between 200 and 300. */
  private static final double BONE_HOUNSFIELD = 250;

  /** The least value of skin in Hounsfield units: between air, -1000, and fat, -100. */
  private static final double SKIN_HOUNSFIELD = -300;

  private static final String HOUNSFIELD_REASON =
      "the values look like Hounsfield units: air near -1000, soft tissue near 0; bone begins"
          + " between 200 and 300, skin at -300";

  private static final String OTSU_REASON =
      "these values split the histogram into three classes, by Otsu's method";

  /** Returns proposals for intensities, the hardest first; empty if there are too few values. */
  public static List<SegmentProposal> of(ValueStatistics.Summary found) {
    if (found.hounsfield()) {
      return List.of(
          new SegmentProposal("bone", BONE_HOUNSFIELD, true),
          new SegmentProposal("skin", SKIN_HOUNSFIELD, true));
    }
    List<Double> thresholds = found.thresholds();
    return thresholds.size() == 2
        ? List.of(
            new SegmentProposal("bone", thresholds.get(1), false),
            new SegmentProposal("tissue", thresholds.get(0), false))
        : List.of();
  }

  /** Returns the reason for the proposals; empty if there are none. */
  public static String reason(ValueStatistics.Summary found) {
    if (found.hounsfield()) {
      return HOUNSFIELD_REASON;
    }
    return found.thresholds().size() == 2 ? OTSU_REASON : "";
  }
}
