package org.palpate.force;

import org.palpate.geometry.Pose;
import org.palpate.rigid.ToolMotion;

/**
 * Proposes where a rigid tool goes instead of the device pose. The solver verifies every step
 * towards it as ever, and the coupling pulls the device to the tool. So a proposal is felt, and the
 * guarantee does not depend on it.
 *
 * <p>Haptic thread; an implementation allocates nothing.
 */
public interface ToolProposal {
  /**
   * {@return whether the tool may move in a way that the hand does not} The coupling force then
   * follows as slowly as after a jump.
   */
  default boolean jumps() {
    return true;
  }

  /**
   * Begins anew, because the tool was placed without a path.
   *
   * @param tool where the tool is now, world mm
   */
  void reset(Pose tool);

  /**
   * Returns the pose that the tool is to reach.
   *
   * @param device the device pose, world mm, with a unit quaternion
   * @param motion the tool where the last frame left it
   * @param elapsedNanos time since the last call
   * @return belongs to the proposal and changes with the next call; finite, with a unit quaternion
   */
  Pose propose(Pose device, ToolMotion motion, long elapsedNanos);
}
