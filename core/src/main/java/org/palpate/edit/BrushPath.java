package org.palpate.edit;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;

/**
 * The path of a brush that follows the tool, in the grid coordinates of the painted segment. The
 * edits of one stroke share it, and only the haptic thread moves along it.
 */
public final class BrushPath {
  /** The longest piece of a path, radii of the brush; a tool that moves farther has jumped. */
  private static final double JUMP_RADII = 8;

  /** The end of the last piece; NaN before the first. */
  private final Vec3 end = new Vec3(Double.NaN, Double.NaN, Double.NaN);

  /** Creates a path that has not begun. */
  public BrushPath() {}

  /**
   * Goes on to where the tool is now. The piece begins where the last one ended, or at its own end
   * if it is the first one or the tool has jumped.
   *
   * @param destFrom receives the beginning of the piece
   */
  void goTo(Vec3 now, GridMetric metric, double radiusMm, Vec3 destFrom) {
    double square = metric.squaredDistance(end.x, end.y, end.z, now.x, now.y, now.z);
    double mostMm = JUMP_RADII * radiusMm;
    boolean goesOn = square <= mostMm * mostMm; // false for NaN
    destFrom.set(goesOn ? end : now);
    end.set(now);
  }
}
