package org.palpate.fracture.fit;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * Lays a pair of rim points on a pair of another surface: their middles and the lines through them
 * coincide, and the rotation about that line is the one at which the tangents agree best. One
 * thread an instance.
 */
final class RimLaying {
  /** The least length of the sum of two outward directions across the line. */
  private static final double LEAST_ACROSS = 0.5;

  /** The least cosine between an outward direction and the reverse of the one it is laid on. */
  private static final double LIKE_OUTWARD = 0.5;

  /** The least cosine between tangents. */
  private static final double LIKE_TANGENT = 0.9;

  private final Vec3[] own = {new Vec3(), new Vec3(), new Vec3()};
  private final Vec3[] other = {new Vec3(), new Vec3(), new Vec3()};
  private final Vec3 along = new Vec3();
  private final Vec3 turned = new Vec3();
  private final Vec3 faced = new Vec3();
  private final Vec3 scratch = new Vec3();
  private final Quaternion turn = new Quaternion();

  /**
   * Finds the pose that lays a pair on another.
   *
   * @param first the point that the first one is laid on
   * @param second the point that the second one is laid on
   * @param dest receives the pose
   * @return whether both pairs fit
   */
  boolean lay(
      RimPoints.Frame one,
      RimPoints.Frame two,
      RimPoints.Frame first,
      RimPoints.Frame second,
      Pose dest) {
    if (!axes(one, two, 1, own) || !axes(first, second, -1, other)) {
      return false;
    }
    turn.setAxes(own[0], own[1], own[2]).conjugate(turn);
    dest.rotation.setAxes(other[0], other[1], other[2]);
    dest.rotation.multiply(turn, dest.rotation).normalize();
    turnTangents(one, two, first, second, dest);
    one.point().add(two.point(), turned);
    dest.rotation.rotate(turned, turned);
    first.point().add(second.point(), dest.translation);
    dest.translation.sub(turned, dest.translation).mul(0.5, dest.translation);
    return isAlike(one, first, dest) && isAlike(two, second, dest);
  }

  /**
   * Finds the axes of a pair: x along it, and z as the sum of the outward directions across it.
   * Returns false if that sum is short.
   */
  private static boolean axes(RimPoints.Frame one, RimPoints.Frame two, int sign, Vec3[] dest) {
    two.point().sub(one.point(), dest[0]);
    dest[0].mul(1 / dest[0].length(), dest[0]);
    one.outward().add(two.outward(), dest[2]).mul(sign, dest[2]);
    dest[2].sub(dest[0].mul(dest[0].dot(dest[2]), dest[1]), dest[2]);
    double length = dest[2].length();
    if (length < LEAST_ACROSS) {
      return false;
    }
    dest[2].mul(1 / length, dest[2]).cross(dest[0], dest[1]);
    return true;
  }

  /** Turns a pose about the line of the other pair until the tangents agree best. */
  private void turnTangents(
      RimPoints.Frame one,
      RimPoints.Frame two,
      RimPoints.Frame first,
      RimPoints.Frame second,
      Pose pose) {
    along.set(other[0]);
    double cosine = 0;
    double sine = 0;
    for (int n = 0; n < 2; n++) {
      pose.rotation.rotate((n == 0 ? one : two).tangent(), turned);
      faced.set((n == 0 ? first : second).tangent());
      double sign = Math.signum(turned.dot(faced));
      cosine += sign * (turned.dot(faced) - turned.dot(along) * faced.dot(along));
      sine += sign * turned.cross(faced, scratch).dot(along);
    }
    turn.setRotationVector(along.mul(StrictMath.atan2(sine, cosine), along));
    turn.multiply(pose.rotation, pose.rotation).normalize();
  }

  private boolean isAlike(RimPoints.Frame one, RimPoints.Frame first, Pose pose) {
    return -pose.rotation.rotate(one.outward(), turned).dot(first.outward()) >= LIKE_OUTWARD
        && Math.abs(pose.rotation.rotate(one.tangent(), turned).dot(first.tangent()))
            >= LIKE_TANGENT;
  }
}
