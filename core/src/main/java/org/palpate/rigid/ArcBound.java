package org.palpate.rigid;

import org.palpate.geometry.Vec3;

/**
 * Bounds how far a point leaves the chord of its motion, as a body sees it. If a step is so large
 * that chords cannot stand for arcs, verification adds this to the spheres that must be empty.
 *
 * <p>There are two cases. If the points turn, each moves on an arc about their reference point. If
 * the body with the voxels turns, the body sees each point move about the body's reference point,
 * which itself moves; see docs/guarantee.md. Haptic thread only.
 */
final class ArcBound {
  private double perMm;
  private double constantMm;
  private double centreX;
  private double centreY;
  private double centreZ;

  /**
   * Sets the bound for points that turn.
   *
   * @param centre the point about which they turn, in their frame, mm
   */
  void setPointsTurn(double turnRad, Vec3 centre) {
    perMm = 1 - Math.cos(Math.min(Math.PI, turnRad) / 2);
    constantMm = 0;
    setCentre(centre);
  }

  /**
   * Sets the bound for a body that turns about its reference point.
   *
   * @param centre the reference point before the motion, in the frame of the points, mm
   */
  void setBodyTurns(double shiftMm, double turnRad, Vec3 centre) {
    perMm = turnRad * turnRad / 8;
    constantMm = ofTurningBody(shiftMm, turnRad, shiftMm);
    setCentre(centre);
  }

  private void setCentre(Vec3 centre) {
    centreX = centre.x;
    centreY = centre.y;
    centreZ = centre.z;
  }

  /**
   * Returns the largest deviation of a point from its chord, in the frame of a body that turns and
   * shifts.
   *
   * @param shiftMm the motion of the body's reference point
   * @param distanceMm the largest distance of the point from that reference point
   */
  static double ofTurningBody(double shiftMm, double turnRad, double distanceMm) {
    return (2 * turnRad * shiftMm + turnRad * turnRad * distanceMm) / 8;
  }

  /** Returns the largest deviation of a point of a sphere in the frame of the points, mm. */
  double deviationMm(double x, double y, double z, double radiusMm) {
    double a = x - centreX;
    double b = y - centreY;
    double c = z - centreZ;
    return perMm * (Math.sqrt(a * a + b * b + c * c) + radiusMm) + constantMm;
  }
}
