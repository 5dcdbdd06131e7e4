package org.palpate.geometry;

/**
 * A rotation (or rotation with mirroring) followed by a translation. Immutable; a name says from
 * where to where, as in {@code gridMmToWorld}.
 *
 * @param axisX where the unit x axis of the source goes, a unit vector
 * @param axisY where the unit y axis goes, a unit vector orthogonal to the others
 * @param axisZ where the unit z axis goes
 * @param origin where the source's origin goes
 */
public record RigidTransform(Vec3 axisX, Vec3 axisY, Vec3 axisZ, Vec3 origin) {

  /** How far lengths and angles may be off before a file's axes count as not orthonormal. */
  public static final double ORTHONORMAL_TOLERANCE = 1e-4;

  public static RigidTransform identity() {
    return new RigidTransform(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), new Vec3());
  }

  /** Writes the image of {@code point} into {@code dest}, which may be {@code point}. */
  public Vec3 transform(Vec3 point, Vec3 dest) {
    return rotate(point, dest).add(origin, dest);
  }

  /**
   * Writes the image of the direction {@code vector} into {@code dest}, which may be {@code
   * vector}.
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
   * Writes the point whose image is {@code point} into {@code dest}, which may be {@code point}.
   */
  public Vec3 inverseTransform(Vec3 point, Vec3 dest) {
    return inverseRotate(point.sub(origin, dest), dest);
  }

  /**
   * Writes the direction whose image is {@code vector} into {@code dest}, which may be {@code
   * vector}.
   */
  public Vec3 inverseRotate(Vec3 vector, Vec3 dest) {
    return dest.set(axisX.dot(vector), axisY.dot(vector), axisZ.dot(vector));
  }

  /** Whether the axes are unit vectors at right angles, to {@link #ORTHONORMAL_TOLERANCE}. */
  public boolean isOrthonormal() {
    return isUnit(axisX)
        && isUnit(axisY)
        && isUnit(axisZ)
        && isOrthogonal(axisX, axisY)
        && isOrthogonal(axisY, axisZ)
        && isOrthogonal(axisZ, axisX);
  }

  private static boolean isUnit(Vec3 axis) {
    return Math.abs(axis.length() - 1) <= ORTHONORMAL_TOLERANCE;
  }

  private static boolean isOrthogonal(Vec3 a, Vec3 b) {
    return Math.abs(a.dot(b)) <= ORTHONORMAL_TOLERANCE;
  }
}
