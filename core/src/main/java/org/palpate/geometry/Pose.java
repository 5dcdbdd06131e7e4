package org.palpate.geometry;

/**
 * A rigid motion that can change every frame: a rotation about the origin, then a translation, mm.
 * As the pose of a tool or a body it maps the object's own frame to the world.
 *
 * <p>Mutable; belongs to one thread. {@link RigidTransform} is the immutable counterpart for grids.
 */
public final class Pose {
  /** The translation, mm: where the origin of the object's frame lies. */
  public final Vec3 translation = new Vec3();

  /** The rotation, of norm 1 in every pose that transforms something. */
  public final Quaternion rotation = new Quaternion();

  /**
   * {@return a pose that does not turn its object}
   *
   * @param x the x component to which the object's origin goes, mm
   * @param y its y component
   * @param z its z component
   */
  public static Pose at(double x, double y, double z) {
    Pose pose = new Pose();
    pose.translation.set(x, y, z);
    return pose;
  }

  /**
   * Copies the other pose.
   *
   * @param other the pose to copy
   * @return this pose
   */
  public Pose set(Pose other) {
    translation.set(other.translation);
    rotation.set(other.rotation);
    return this;
  }

  /**
   * Copies a translation and a rotation.
   *
   * @param newTranslation the translation, mm
   * @param newRotation the rotation, a unit quaternion
   * @return this pose
   */
  public Pose set(Vec3 newTranslation, Quaternion newRotation) {
    translation.set(newTranslation);
    rotation.set(newRotation);
    return this;
  }

  /**
   * Copies a motion.
   *
   * @param motion its axes are orthonormal and right-handed, up to rounding; its origin is in mm
   * @return this pose
   */
  public Pose set(RigidTransform motion) {
    translation.set(motion.origin());
    rotation.setAxes(motion.axisX(), motion.axisY(), motion.axisZ());
    return this;
  }

  /**
   * Sets the pose that moves nothing.
   *
   * @return this pose
   */
  public Pose setIdentity() {
    translation.set(0, 0, 0);
    rotation.setIdentity();
    return this;
  }

  /**
   * Writes the image of a point.
   *
   * @param point in the frame that the pose leads from, mm
   * @param dest receives the image; may be the point
   * @return {@code dest}
   */
  public Vec3 transform(Vec3 point, Vec3 dest) {
    return rotation.rotate(point, dest).add(translation, dest);
  }

  /**
   * Writes the point whose image is given.
   *
   * @param point the image, in the frame that the pose leads to, mm
   * @param dest receives the point; may be the image
   * @return {@code dest}
   */
  public Vec3 inverseTransform(Vec3 point, Vec3 dest) {
    return rotation.inverseRotate(point.sub(translation, dest), dest);
  }

  /**
   * Writes the same motion into the vectors of {@code dest}.
   *
   * @param dest its four vectors are overwritten
   * @return {@code dest}
   */
  public RigidTransform transform(RigidTransform dest) {
    rotation.rotate(dest.axisX().set(1, 0, 0), dest.axisX());
    rotation.rotate(dest.axisY().set(0, 1, 0), dest.axisY());
    rotation.rotate(dest.axisZ().set(0, 0, 1), dest.axisZ());
    dest.origin().set(translation);
    return dest;
  }

  /**
   * Writes the pose that applies another one and then this.
   *
   * @param first the pose that is applied first
   * @param dest receives the product; may be this pose or {@code first}
   * @return {@code dest}
   */
  public Pose multiply(Pose first, Pose dest) {
    double x = translation.x;
    double y = translation.y;
    double z = translation.z;
    rotation.rotate(first.translation, dest.translation);
    dest.translation.set(dest.translation.x + x, dest.translation.y + y, dest.translation.z + z);
    rotation.multiply(first.rotation, dest.rotation);
    return dest;
  }

  /**
   * Writes the pose that applies another one and then the inverse of this.
   *
   * @param first the pose that is applied first
   * @param dest receives the product; neither this pose nor {@code first}
   * @return {@code dest}
   */
  public Pose inverseMultiply(Pose first, Pose dest) {
    inverseTransform(first.translation, dest.translation);
    rotation.conjugate(dest.rotation).multiply(first.rotation, dest.rotation);
    return dest;
  }

  /**
   * Writes the pose after a further displacement of its origin and a further rotation about it.
   *
   * @param displacementMm displacement of the origin, world mm
   * @param rotationVector rotation about the moved origin, world axes, rad
   * @param fraction how much of both to apply
   * @param scratch overwritten
   * @param dest may be this
   * @return {@code dest}
   */
  public Pose displace(
      Vec3 displacementMm, Vec3 rotationVector, double fraction, Quaternion scratch, Pose dest) {
    Vec3 to = dest.translation;
    double x = translation.x + fraction * displacementMm.x;
    double y = translation.y + fraction * displacementMm.y;
    double z = translation.z + fraction * displacementMm.z;
    to.set(fraction * rotationVector.x, fraction * rotationVector.y, fraction * rotationVector.z);
    scratch.setRotationVector(to);
    scratch.multiply(rotation, dest.rotation);
    dest.rotation.normalize();
    to.set(x, y, z);
    return dest;
  }

  /**
   * Writes the displacement of the origin and the rotation about it, the short way around, that
   * lead from this pose to another: the inverse of {@link #displace}.
   *
   * @param other the pose to reach
   * @param displacementMm written, world mm
   * @param rotationVector written, world axes, rad, at most pi long
   * @param scratch overwritten
   */
  public void differenceTo(
      Pose other, Vec3 displacementMm, Vec3 rotationVector, Quaternion scratch) {
    other.translation.sub(translation, displacementMm);
    rotation.conjugate(scratch);
    other.rotation.multiply(scratch, scratch);
    scratch.rotationVector(rotationVector);
  }

  /**
   * Writes the pose a part of the way to another: straight for the origin, at a constant rate about
   * one axis for the rotation, the short way around.
   *
   * @param other the pose to reach
   * @param fraction 0 for this pose, 1 for the other
   * @param scratch two vectors and a quaternion, all overwritten
   * @param dest may be this
   * @return {@code dest}
   */
  public Pose interpolate(Pose other, double fraction, Scratch scratch, Pose dest) {
    differenceTo(other, scratch.displacement, scratch.rotation, scratch.quaternion);
    return displace(scratch.displacement, scratch.rotation, fraction, scratch.quaternion, dest);
  }

  /** Room for intermediate results, so that computing with poses allocates nothing. */
  public static final class Scratch {
    private final Vec3 displacement = new Vec3();
    private final Vec3 rotation = new Vec3();
    private final Quaternion quaternion = new Quaternion();
  }

  /** {@return whether no component is NaN or infinite} */
  public boolean isFinite() {
    return translation.isFinite() && rotation.isFinite();
  }

  /**
   * {@return whether both hold the same bits}
   *
   * @param other the pose to compare with
   */
  public boolean sameBits(Pose other) {
    return translation.sameBits(other.translation) && rotation.sameBits(other.rotation);
  }

  @Override
  public String toString() {
    return translation + " " + rotation;
  }
}
