package org.palpate.force.guide;

import org.palpate.force.HandState;
import org.palpate.force.HapticEffect;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * Lets the hand turn about an axis in space, as the jaw does about its condyles. A point stays on
 * the circle about the axis on which it was at the start. A rigid tool or a body in hand stays at
 * the poses that a rotation about the axis makes of its first one.
 *
 * <p>Of these poses the guide pulls to the nearest one. Its distance is the root of the sum of two
 * squares: the offset, and the angle times the lever of the coupling. Haptic thread; allocates
 * nothing.
 */
public final class HingeGuide implements HapticEffect {
  private static final double FULL_TURN = 2 * Math.PI;

  private final Vec3 through;
  private final Vec3 axis;
  private final GuideSpring spring;
  private final GuideSpring turnSpring;
  private final double squaredLeverMm2;
  private final Pose first = new Pose();
  private final Pose last = new Pose();
  private final Pose turned = new Pose();
  private final Vec3 offset = new Vec3();
  private final Vec3 from = new Vec3();
  private final Vec3 to = new Vec3();
  private final Vec3 rotation = new Vec3();
  private final Quaternion scratch = new Quaternion();
  private double angle;
  private boolean known;

  /**
   * Creates a hinge.
   *
   * @param through a position on the axis, mm
   * @param axis its unit direction
   * @param spring the spring of positions, with N and mm
   * @param turnSpring the spring of rotations, with N mm and rad
   * @param leverMm the lever of the coupling, mm; 0 for a point
   */
  public HingeGuide(
      Vec3 through, Vec3 axis, GuideSpring spring, GuideSpring turnSpring, double leverMm) {
    this.through = through;
    this.axis = axis;
    this.spring = spring;
    this.turnSpring = turnSpring;
    squaredLeverMm2 = leverMm * leverMm;
  }

  @Override
  public void reset() {
    known = false;
  }

  @Override
  public void add(HandState hand, Vec3 forceNewton, Vec3 torqueNewtonMm) {
    if (!known) {
      first.set(hand.device);
      last.set(hand.device);
      angle = 0;
      known = true;
    }
    approach(nearestAngle(hand.device), hand.device, PositionGuide.leastStepMm(hand));
    turnFirst(angle);
    hand.device.differenceTo(turned, offset, rotation, scratch);
    spring.pull(offset, forceNewton);
    if (hand.isRigid) {
      turnSpring.pull(rotation, torqueNewtonMm);
    }
  }

  /**
   * Turns towards an angle. If the nearest pose jumps, as it does when the hand crosses the axis,
   * the guide follows as a {@link PositionGuide} does.
   */
  private void approach(double wanted, Pose at, double leastStepMm) {
    last.differenceTo(at, offset, rotation, scratch);
    double motionMm = Math.sqrt(offset.dot(offset) + squaredLeverMm2 * rotation.dot(rotation));
    double mostMm = Math.max(leastStepMm, 2 * motionMm);
    double squaredArmMm2 = from.dot(from) + squaredLeverMm2;
    double step = wanted - angle;
    step -= FULL_TURN * Math.rint(step / FULL_TURN);
    if (step * step * squaredArmMm2 > mostMm * mostMm) {
      step *= mostMm / Math.sqrt(step * step * squaredArmMm2);
    }
    angle += step;
    last.set(at);
  }

  /** Returns the angle of the nearest pose that the hinge allows, rad. */
  private double nearestAngle(Pose at) {
    arm(first, from);
    arm(at, to);
    double cosine = from.dot(to);
    double sine = from.cross(to, offset).dot(axis);
    at.rotation.multiply(first.rotation.conjugate(scratch), scratch);
    double twist = scratch.x * axis.x + scratch.y * axis.y + scratch.z * axis.z;
    double norm = scratch.w * scratch.w + twist * twist;
    if (norm > 0) {
      cosine += squaredLeverMm2 * (scratch.w * scratch.w - twist * twist) / norm;
      sine += squaredLeverMm2 * 2 * scratch.w * twist / norm;
    }
    return StrictMath.atan2(sine, cosine);
  }

  /** Writes the vector from the axis to a position, at right angles to the axis. */
  private void arm(Pose pose, Vec3 dest) {
    pose.translation.sub(through, dest);
    axis.mul(dest.dot(axis), offset);
    dest.sub(offset, dest);
  }

  /** Writes the first pose, turned about the axis, into {@link #turned}. */
  private void turnFirst(double byAngle) {
    scratch.setRotationVector(axis.mul(byAngle, rotation));
    first.translation.sub(through, offset);
    scratch.rotate(offset, offset).add(through, turned.translation);
    scratch.multiply(first.rotation, turned.rotation);
    turned.rotation.normalize();
  }
}
