package org.palpate.rigid;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;

/**
 * Converts between the two forms of a movable body's pose. The pose of a {@link
 * org.palpate.body.Body} turns the body about the origin of the world. The pose of its reference
 * point, about which solver and metric work, states where that point lies.
 *
 * <p>Translations of movable bodies, and the reference point's rotated offset from the origin, are
 * multiples of {@link #LATTICE_MM} and at most {@link #LARGEST_MM} long along an axis. Hence sums
 * and differences of two are exact. A conversion there and back gives the same bits.
 *
 * <p>Keeps scratch: haptic thread only.
 */
public final class ReferencePose {
  /** Translations of movable bodies are multiples of this, mm. */
  public static final double LATTICE_MM = 0x1p-32;

  /** The largest translation of a movable body along an axis, mm. */
  public static final double LARGEST_MM = 1 << 20;

  private static final double PER_MM = 1 / LATTICE_MM;

  private final Vec3 referenceMm;
  private final Vec3 offset = new Vec3();

  /**
   * Creates a conversion for a body.
   *
   * @param referenceMm the reference point of the body at rest, world mm
   */
  public ReferencePose(Vec3 referenceMm) {
    this.referenceMm = referenceMm;
  }

  /**
   * Moves the translation of a pose to the nearest one that a movable body can have.
   *
   * @param pose changed in place
   * @return {@code pose}
   */
  public static Pose snap(Pose pose) {
    snap(pose.translation);
    return pose;
  }

  private static void snap(Vec3 v) {
    v.set(snapped(v.x), snapped(v.y), snapped(v.z));
  }

  private static double snapped(double mm) {
    double near = Math.max(-LARGEST_MM, Math.min(LARGEST_MM, mm));
    return Math.rint(near * PER_MM) * LATTICE_MM + 0.0; // no negative zero
  }

  /**
   * Writes the pose of the reference point from a snapped pose from rest to present.
   *
   * @param restToPresent the pose of the body, snapped, world mm
   * @param dest receives the pose of the reference point, world mm
   * @return {@code dest}
   */
  public Pose toReference(Pose restToPresent, Pose dest) {
    rotateOffset(restToPresent);
    dest.rotation.set(restToPresent.rotation);
    restToPresent.translation.add(offset, dest.translation);
    return dest;
  }

  /**
   * Writes the pose from rest to present from a snapped pose of the reference point.
   *
   * @param reference the pose of the reference point, snapped, world mm
   * @param dest receives the pose from rest to present, world mm
   * @return {@code dest}
   */
  public Pose toRest(Pose reference, Pose dest) {
    rotateOffset(reference);
    dest.rotation.set(reference.rotation);
    reference.translation.sub(offset, dest.translation);
    return dest;
  }

  /**
   * Writes the pose of a second reference point in the frame of a first.
   *
   * @param first the pose of the first reference point, world mm
   * @param second the pose of the second, world mm
   * @param dest receives the relative pose; neither of them
   * @return {@code dest}
   */
  public static Pose relative(Pose first, Pose second, Pose dest) {
    first.inverseMultiply(second, dest).rotation.normalize();
    return dest;
  }

  /**
   * Writes the snapped pose of a reference point that is glued to a first one.
   *
   * @param first the pose of the first reference point, world mm
   * @param relative the pose of the second in the frame of the first
   * @param dest receives the pose of the second, world mm
   * @return {@code dest}
   */
  public static Pose glued(Pose first, Pose relative, Pose dest) {
    first.multiply(relative, dest).rotation.normalize();
    return snap(dest);
  }

  private void rotateOffset(Pose pose) {
    pose.rotation.rotate(referenceMm, offset);
    snap(offset);
  }
}
