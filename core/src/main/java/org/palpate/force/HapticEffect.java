package org.palpate.force;

import org.palpate.geometry.Vec3;

/**
 * A port for forces that the hand feels beside contact: virtual fixtures, which guide the hand, and
 * effects such as viscosity.
 *
 * <p>An effect never moves the tool; it only adds force and torque, so the guarantee does not
 * depend on it. {@link HapticEffects} fades effects in and out, and the limiter of the frame bounds
 * the sum. The force of an effect should change little while the hand moves little.
 *
 * <p>Haptic thread: an implementation allocates nothing and does a bounded amount of work. An
 * instance may keep state and belongs to one frame.
 */
@FunctionalInterface
public interface HapticEffect {
  /**
   * Adds force and torque of this frame.
   *
   * @param hand the motion of the hand in the frame's coordinates; read only
   * @param forceNewton the sum of the effects so far, N; changed
   * @param torqueNewtonMm the same for the torque about the reference point of what is held, N mm;
   *     changed
   */
  void add(HandState hand, Vec3 forceNewton, Vec3 torqueNewtonMm);

  /**
   * Forgets earlier frames, because the hand now holds something else or elsewhere. The frame calls
   * it before the first {@link #add}, too.
   */
  default void reset() {}
}
