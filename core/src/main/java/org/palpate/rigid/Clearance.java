package org.palpate.rigid;

import org.palpate.geometry.GridMetric;

/**
 * The distance that a tool's points keep from a body, and the steps in which it is reached.
 *
 * @param growthMm the points stay at least this far from every voxel, mm; 0 if only their legs must
 *     not touch
 * @param longestCellMm the longest edge of the cells that the grown solids are made of, mm
 * @param levels the number of steps into which the distance is divided for points that start nearer
 */
public record Clearance(double growthMm, double longestCellMm, int levels) {
  /** No clearance: the legs of the points touch no voxel. */
  public static final Clearance POINTS = new Clearance(0, 1, 0);

  /** Cells may be longer than the growth by this factor, so that voxels that fit are not cut. */
  private static final double LONGEST_CELL = 1.2;

  /** Points that start nearer than the clearance keep a half of it, if they have that. */
  private static final int LEVELS = 2;

  /** The length that a clearance adds for the rounding of poses and points, mm. */
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
   * radius of the tool's points, the arc of a step above its chord, and rounding.
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
    return new Clearance(growthMm, LONGEST_CELL * growthMm, LEVELS);
  }
}
