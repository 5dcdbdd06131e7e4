package org.palpate.force;

/**
 * Makes an effect for a frame. Each frame has effects of its own, because they keep state. Any
 * thread, before the frame runs.
 */
@FunctionalInterface
public interface EffectPlan {
  /**
   * {@return a new effect}
   *
   * @param site the coordinates and the stiffness of the frame
   */
  HapticEffect make(EffectSite site);
}
