package org.palpate.rigid;

import org.palpate.geometry.GridMetric;

/**
 * How far a tool's points stay away from a body, and in which steps that distance is reached.
 *
 * @param growthMm the points stay at least this far from every voxel, mm; 0 if only their legs must
 *     not touch
 * @param parts cells along the edge of a voxel that the grown solids are made of: 1, 2 or 4
 * @param levels into how many steps the distance is divided for points that start nearer
 */
public record Clearance(double growthMm, int parts, int levels) {
  /** No clearance: the legs of the points touch no voxel. */
  public static final Clearance POINTS = new Clearance(0, 1, 0);

  /** What a clearance adds for the rounding of poses and points, mm. */
  private static final double ROUNDING_MM = 1e-6;

  /** Checks the distance. */
  public Clearance {
    if (!(growthMm >= 0 && growthMm < Double.POSITIVE_INFINITY) || levels < 0) {
      throw new IllegalArgumentException(
          "clearance must not be negative: growthMm=" + growthMm + " levels=" + levels);
    }
  }

  /**
   * Returns the least clearance at which the tool and a body, as solids, cannot overlap: the cover
   * radius of the tool's points, the arc of a step above its chord, and rounding. Grown by cells no
   * larger than a half of that, or by voxels if they are not larger.
   *
   * @param marginMm added, mm; may be negative
   */
  public static Clearance ofWholeBody(ToolPoints tool, GridMetric metric, double marginMm) {
    if (!(tool.coverRadiusMm() < ToolPoints.NOT_COVERED)) {
      throw new IllegalArgumentException("the points of this tool do not cover its surface");
    }
    double sagittaMm = StepLimits.SAGITTA_EDGES * metric.shortestEdgeMm();
    double growthMm = tool.coverRadiusMm() + sagittaMm + ROUNDING_MM + marginMm;
    if (!(growthMm > 0)) {
      return POINTS;
    }
    double longestMm = Math.max(metric.spacingX(), Math.max(metric.spacingY(), metric.spacingZ()));
    int parts = longestMm <= 1.2 * growthMm ? 1 : longestMm <= 2.4 * growthMm ? 2 : 4;
    return new Clearance(growthMm, parts, Math.max(1, parts / 2));
  }
}
