package org.palpate.geometry;

/**
 * A rotation, perhaps with a reflection, followed by a translation. The name of a variable states
 * from and to, as in {@code gridMmToWorld}.
 *
 * <p>The vectors are not copied, so the caller must not keep them. They do not change after
 * construction, except in a transform that its owner keeps as a {@code dest}.
 *
 * @param axisX the image of the x axis of the source, a unit vector
 * @param axisY the image of its y axis, a unit vector orthogonal to the others
 * @param axisZ the image of its z axis, a unit vector orthogonal to the others
 * @param origin the image of its origin
 */
public record RigidTransform(Vec3 axisX, Vec3 axisY, Vec3 axisZ, Vec3 origin) {

  /** The largest error of a length or a dot product of axes that count as orthonormal. */
  public static final double ORTHONORMAL_TOLERANCE = 1e-4;

  /** {@return a new identity transform} */
  public static RigidTransform identity() {
    return new RigidTransform(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), new Vec3());
  }

  /** {@return whether this mirrors, so that it turns right-handed axes into left-handed ones} */
  public boolean isMirrored() {
    return axisX.dot(axisY.cross(axisZ, new Vec3())) < 0;
  }

  /**
   * Writes the image of a point.
   *
   * @param point in the frame that the transform leads from, in the unit of the origin
   * @param dest receives the image; may be {@code point}
   * @return {@code dest}
   */
  public Vec3 transform(Vec3 point, Vec3 dest) {
    return rotate(point, dest).add(origin, dest);
  }

  /**
   * Writes the image of a direction, without the translation.
   *
   * @param vector in the frame that the transform leads from
   * @param dest receives the image; may be {@code vector}
   * @return {@code dest}
   */
  public Vec3 rotate(Vec3 vector, Vec3 dest) {
    double x = vector.x;
    double y = vector.y;
    double z = vector.z;
    return dest.set(
        axisX.x * x + axisY.x * y + axisZ.x * z,
        axisX.y * x + axisY.y * y + axisZ.y * z,
        axisX.z * x + axisY.z * y + axisZ.z * z);
  }

  /**
   * {@return whether both have the same bits}
   *
   * @param other the transform to compare with
   */
  public boolean sameBits(RigidTransform other) {
    return axisX.sameBits(other.axisX)
        && axisY.sameBits(other.axisY)
        && axisZ.sameBits(other.axisZ)
        && origin.sameBits(other.origin);
  }

  /**
   * {@return a new transform that applies another one and then this}
   *
   * @param first the transform that is applied first
   */
  public RigidTransform multiply(RigidTransform first) {
    return new RigidTransform(
        rotate(first.axisX, new Vec3()),
        rotate(first.axisY, new Vec3()),
        rotate(first.axisZ, new Vec3()),
        transform(first.origin, new Vec3()));
  }

  /**
   * Writes the point whose image is given.
   *
   * @param point the image, in the frame that the transform leads to
   * @param dest receives the point; may be {@code point}
   * @return {@code dest}
   */
  public Vec3 inverseTransform(Vec3 point, Vec3 dest) {
    return inverseRotate(point.sub(origin, dest), dest);
  }

  /**
   * Writes the direction whose image is given.
   *
   * @param vector the image, in the frame that the transform leads to
   * @param dest receives the direction; may be {@code vector}
   * @return {@code dest}
   */
  public Vec3 inverseRotate(Vec3 vector, Vec3 dest) {
    return dest.set(axisX.dot(vector), axisY.dot(vector), axisZ.dot(vector));
  }

  /** {@return whether the axes are orthogonal unit vectors, to {@link #ORTHONORMAL_TOLERANCE}} */
  public boolean isOrthonormal() {
    return isUnit(axisX)
        && isUnit(axisY)
        && isUnit(axisZ)
        && isOrthogonal(axisX, axisY)
        && isOrthogonal(axisY, axisZ)
        && isOrthogonal(axisZ, axisX);
  }

  /**
   * {@return a bound of the relative change of lengths, 0 for orthonormal axes: the Frobenius norm
   * of A^T A - I, where A has the axes as columns} The transposed matrix has the same bound.
   */
  public double distortion() {
    double x = axisX.dot(axisX) - 1;
    double y = axisY.dot(axisY) - 1;
    double z = axisZ.dot(axisZ) - 1;
    double xy = axisX.dot(axisY);
    double yz = axisY.dot(axisZ);
    double zx = axisZ.dot(axisX);
    return Math.sqrt(x * x + y * y + z * z + 2 * (xy * xy + yz * yz + zx * zx));
  }

  private static boolean isUnit(Vec3 axis) {
    return Math.abs(axis.length() - 1) <= ORTHONORMAL_TOLERANCE;
  }

  private static boolean isOrthogonal(Vec3 a, Vec3 b) {
    return Math.abs(a.dot(b)) <= ORTHONORMAL_TOLERANCE;
  }
}
