package org.palpate.force;

import java.util.List;
import org.palpate.geometry.Vec3;

/**
 * The effects of a frame, which begin and end without a step in the force.
 *
 * <p>If other effects are wanted, or if the hand takes hold of something else, the force passes
 * from the last one to that of the present effects within {@link ForceRamp#DEFAULT_NANOS}. A force
 * that is not finite counts as zero.
 *
 * <p>Haptic thread; allocates nothing.
 */
public final class HapticEffects {
  private final ForceRamp ramp = new ForceRamp(ForceRamp.DEFAULT_NANOS);
  private final Vec3 force = new Vec3();
  private final Vec3 torque = new Vec3();
  private final Vec3 lastForce = new Vec3();
  private final Vec3 lastTorque = new Vec3();
  private final Vec3 formerForce = new Vec3();
  private final Vec3 formerTorque = new Vec3();
  private List<HapticEffect> effects = List.of();

  /**
   * Changes to other effects; does nothing if they are the present ones.
   *
   * @param wanted the effects from now on; not changed any more
   */
  @SuppressWarnings("ReferenceEquality") // each frame asks, nearly always with the same list
  public void use(List<HapticEffect> wanted) {
    if (wanted != effects) {
      effects = wanted;
      beginAnew();
    }
  }

  /** {@return whether there is an effect, or one that still fades out} */
  public boolean areActive() {
    return !effects.isEmpty() || ramp.factor() < 1;
  }

  /** Lets the effects forget earlier frames and passes from the last force to theirs. */
  public void beginAnew() {
    formerForce.set(lastForce);
    formerTorque.set(lastTorque);
    ramp.start();
    for (int n = 0; n < effects.size(); n++) {
      effects.get(n).reset();
    }
  }

  /** Notes that the hand felt no force, so the next one begins at zero. */
  public void drop() {
    lastForce.set(0, 0, 0);
    lastTorque.set(0, 0, 0);
  }

  /**
   * Adds the effects to force and torque of a frame.
   *
   * @param hand the motion and the contact of this frame
   * @param elapsedNanos time since the last frame
   * @param forceNewton changed, N
   * @param torqueNewtonMm changed, N mm
   */
  public void add(HandState hand, long elapsedNanos, Vec3 forceNewton, Vec3 torqueNewtonMm) {
    force.set(0, 0, 0);
    torque.set(0, 0, 0);
    for (int n = 0; n < effects.size(); n++) {
      effects.get(n).add(hand, force, torque);
    }
    if (!force.isFinite() || !torque.isFinite()) {
      force.set(0, 0, 0);
      torque.set(0, 0, 0);
    }
    ramp.advance(elapsedNanos);
    double factor = ramp.factor();
    blend(formerForce, force, factor, lastForce);
    blend(formerTorque, torque, factor, lastTorque);
    forceNewton.add(lastForce, forceNewton);
    torqueNewtonMm.add(lastTorque, torqueNewtonMm);
  }

  private static void blend(Vec3 former, Vec3 now, double factor, Vec3 dest) {
    now.mul(factor, dest);
    dest.x += (1 - factor) * former.x;
    dest.y += (1 - factor) * former.y;
    dest.z += (1 - factor) * former.z;
  }

  /** {@return the force of the effects in the last frame, N} */
  public Vec3 lastForceNewton() {
    return lastForce;
  }

  /** {@return the torque of the effects in the last frame, N mm} */
  public Vec3 lastTorqueNewtonMm() {
    return lastTorque;
  }
}
