package org.palpate.rigid;

import org.palpate.rigid.tool.RigidTool;
import org.palpate.volume.VoxelGrid;

/**
 * The distance that the sample points of a tool keep from a body.
 *
 * @param growthMm the distance from every voxel, mm; 0 if only the legs must not touch a voxel
 * @param longestCellMm the longest edge of the cells that make up the grown solids, mm
 * @param levels the number of steps into which the distance is divided, for points that start
 *     nearer
 */
public record Clearance(double growthMm, double longestCellMm, int levels) {
  /** The clearance of mode {@code points}: no leg touches a voxel, and no more. */
  public static final Clearance POINTS = new Clearance(0, 1, 0);

  /**
   * Cells may be longer than the growth by this factor, so that whole voxels can serve as cells.
   */
  private static final double LONGEST_CELL = 1.2;

  /** Points that start nearer than the clearance keep a half of it, if they have that. */
  private static final int LEVELS = 2;

  /** The allowance for the rounding of poses and of points, mm; docs/guarantee.md derives it. */
  static final double ROUNDING_MM = 1e-6;

  /**
   * Checks the distance.
   *
   * @throws IllegalArgumentException if it is negative or not finite
   */
  public Clearance {
    if (!(growthMm >= 0 && growthMm < Double.POSITIVE_INFINITY) || levels < 0) {
      throw new IllegalArgumentException(
          "clearance must not be negative: growthMm=" + growthMm + " levels=" + levels);
    }
  }

  /**
   * {@return the clearance at which each sample point keeps a margin from a body}
   *
   * @param grid the grid of the body
   * @param marginMm the least distance of a point from a solid voxel, mm, positive
   */
  public static Clearance ofPoints(VoxelGrid grid, double marginMm) {
    double growthMm = marginMm * (1 + grid.gridMmToWorld().distortion()) + ROUNDING_MM;
    return new Clearance(growthMm, LONGEST_CELL * growthMm, LEVELS);
  }

  /**
   * {@return the clearance of mode {@code body}, at which the solid of a tool and a body cannot
   * overlap: the cover radius of the sample points, the deviation of arcs from chords, and
   * rounding}
   *
   * @param tool a tool whose sample points cover its surface
   * @param grid the grid of the body
   * @param marginMm the least gap between the solids, mm, at least 0
   * @throws IllegalArgumentException if the points do not cover the tool or the margin is negative
   */
  public static Clearance ofWholeBody(RigidTool tool, VoxelGrid grid, double marginMm) {
    if (!tool.isCovered()) {
      throw new IllegalArgumentException("the points of this tool do not cover its surface");
    }
    if (!(marginMm >= 0)) {
      throw new IllegalArgumentException(
          "a negative margin needs an eroded tool: marginMm=" + marginMm);
    }
    double sagittaMm = StepLimits.SAGITTA_EDGES * grid.metric().shortestEdgeMm();
    double lengthMm = tool.coverRadiusMm() + sagittaMm + marginMm;
    double growthMm = lengthMm * (1 + grid.gridMmToWorld().distortion()) + ROUNDING_MM;
    return new Clearance(growthMm, LONGEST_CELL * growthMm, LEVELS);
  }
}
