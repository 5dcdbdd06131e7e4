package org.palpate.geometry;

/**
 * Bounds how far a point leaves the chord of its motion, as a body sees it. If a step is so large
 * that chords cannot stand for arcs, verification adds this to the spheres that must be empty.
 *
 * <p>There are two cases. If the points turn, each moves on an arc about their reference point. If
 * the body with the voxels turns, the body sees each point move about the body's reference point,
 * which itself moves; see docs/guarantee.md. Haptic thread only.
 */
public final class ArcBound {
  /**
   * The allowance for the square of an angle between two quaternions, rad^2: pi^2 times the largest
   * error of a squared norm that {@link Quaternion#isUnit} allows, and rounding.
   */
  private static final double SQUARE_ERROR = 1e-11;

  private double perMm;
  private double constantMm;
  private double centreX;
  private double centreY;
  private double centreZ;

  /**
   * Sets the bound for points that turn.
   *
   * @param turnRad the angle by which they turn, rad, at least 0
   * @param centre the point about which they turn, in their frame, mm
   */
  public void setPointsTurn(double turnRad, Vec3 centre) {
    perMm = 1 - Math.cos(Math.min(Math.PI, turnRad) / 2);
    constantMm = 0;
    setCentre(centre);
  }

  /**
   * Sets the bound for a body that turns about its reference point.
   *
   * @param shiftMm the distance by which the reference point moves, mm
   * @param turnRad the angle by which the body turns, rad, at least 0
   * @param centre the reference point before the motion, in the frame of the points, mm
   */
  public void setBodyTurns(double shiftMm, double turnRad, Vec3 centre) {
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
   * {@return the largest deviation of a point from its chord, in the frame of a body that turns and
   * shifts, mm}
   *
   * @param shiftMm the motion of the body's reference point
   * @param turnRad the angle by which the body turns, rad, at least 0
   * @param distanceMm the largest distance of the point from that reference point
   */
  public static double ofTurningBody(double shiftMm, double turnRad, double distanceMm) {
    return (2 * turnRad * shiftMm + turnRad * turnRad * distanceMm) / 8;
  }

  /**
   * {@return a radius about the reference point of a body that turns and shifts} A point that stays
   * farther from the moving reference point touches nothing of the body, neither on its arc nor on
   * its chord in the frame of the body.
   *
   * <p>Let r be the radius of the body, s the shift, a the turn, and d the least distance of the
   * point. By {@link #ofTurningBody} the chord leaves the arc by at most (2 a s + a^2 (d + s))/8.
   * So it stays outside of r if d (1 - a^2/8) is larger than r + (2 a + a^2) s/8.
   *
   * @param radiusMm the radius of the body
   * @param shiftMm the motion of the reference point
   * @param from the orientation before the motion, a unit quaternion
   * @param to the orientation after it, a unit quaternion
   */
  public static double sweptRadiusMm(
      double radiusMm, double shiftMm, Quaternion from, Quaternion to) {
    double cosine = Math.abs(from.dot(to));
    // The turn is twice the arc cosine of c, whose square is at most pi^2/4 (1 - c).
    double square = Math.PI * Math.PI * Math.max(0, 1 - cosine) + SQUARE_ERROR;
    if (square > 1) {
      return Double.POSITIVE_INFINITY;
    }
    double turnRad = Math.sqrt(square);
    return (radiusMm + (2 * turnRad + square) * shiftMm / 8) / (1 - square / 8);
  }

  /**
   * {@return the largest deviation of a point of a sphere in the frame of the points, mm}
   *
   * @param x the x component of the sphere's centre, in the frame of the points, mm
   * @param y its y component
   * @param z its z component
   * @param radiusMm the radius of the sphere, mm
   */
  public double deviationMm(double x, double y, double z, double radiusMm) {
    double a = x - centreX;
    double b = y - centreY;
    double c = z - centreZ;
    return perMm * (Math.sqrt(a * a + b * b + c * c) + radiusMm) + constantMm;
  }
}
