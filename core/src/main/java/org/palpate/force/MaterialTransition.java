package org.palpate.force;

import org.palpate.proxy.InteractionPoint;

/**
 * The material that the hand feels, with a bounded transition from one object to the next.
 *
 * <p>If contact passes to another object, stiffness, both frictions and damping change together
 * towards those of that object. The transition changes the force in one frame by at most k times
 * the motion of the hand. Here k is the larger of the two stiffnesses. A motion shorter than {@link
 * ChangeBound#MIN_MOTION_EDGES} counts as that long.
 *
 * <p>Haptic thread; allocates nothing.
 */
final class MaterialTransition {
  private final double minMotionMm;
  private double stiffness;
  private double staticFriction;
  private double slidingFriction;
  private double damping;

  /** Whether the tool was pressed against an object in the last frame. */
  private boolean pressed;

  MaterialTransition(double shortestEdgeMm, Material first) {
    minMotionMm = ChangeBound.MIN_MOTION_EDGES * shortestEdgeMm;
    set(first);
  }

  double stiffnessNewtonPerMm() {
    return stiffness;
  }

  double staticFriction() {
    return staticFriction;
  }

  double slidingFriction() {
    return slidingFriction;
  }

  double dampingNewtonSecondPerMm() {
    return damping;
  }

  /** Lets the next frame take its material without transition. */
  void reset() {
    pressed = false;
  }

  /**
   * Takes the material of the touched object: at once if contact begins, else by a transition.
   *
   * @param object the touched object; {@link InteractionPoint#NO_OBJECT} keeps the last material
   * @param contact whether a solid holds the tool back
   * @param stretchMm length of the virtual coupling
   * @param motionMm motion of the hand since the last frame; not used if all objects feel alike
   */
  void follow(
      ForceSettings settings, int object, boolean contact, double stretchMm, double motionMm) {
    if (!settings.distinguishesObjects()) {
      set(settings.general());
    } else if (object != InteractionPoint.NO_OBJECT) {
      Material touched = settings.material(object);
      if (pressed) {
        approach(touched, stretchMm, motionMm);
      } else {
        set(touched);
      }
    }
    pressed = stretchMm > 0 && contact;
  }

  /** Takes a material without transition. */
  void set(Material material) {
    stiffness = material.stiffnessNewtonPerMm();
    staticFriction = material.staticFriction();
    slidingFriction = material.slidingFriction();
    damping = material.dampingNewtonSecondPerMm();
  }

  /**
   * Moves towards a material as far as one frame permits.
   *
   * @param stretchMm length of the virtual coupling
   * @param motionMm motion of the hand since the last frame
   */
  void approach(Material material, double stretchMm, double motionMm) {
    if (equalsFelt(material)) {
      return;
    }
    double stiffer = Math.max(stiffness, material.stiffnessNewtonPerMm());
    double maxChange = ChangeBound.ofMotion(stiffer, motionMm, minMotionMm);
    double change = changeNewton(material, stretchMm, stiffer);
    if (change <= maxChange) {
      set(material);
      return;
    }
    double fraction = maxChange / change;
    stiffness += fraction * (material.stiffnessNewtonPerMm() - stiffness);
    staticFriction += fraction * (material.staticFriction() - staticFriction);
    slidingFriction += fraction * (material.slidingFriction() - slidingFriction);
    damping += fraction * (material.dampingNewtonSecondPerMm() - damping);
  }

  private boolean equalsFelt(Material material) {
    return stiffness == material.stiffnessNewtonPerMm()
        && staticFriction == material.staticFriction()
        && slidingFriction == material.slidingFriction()
        && damping == material.dampingNewtonSecondPerMm();
  }

  /**
   * Returns an upper bound of the change of the force if the material were taken at once, N. It
   * adds up coupling, friction and damping; damping is never longer than the coupling.
   */
  private double changeNewton(Material material, double stretchMm, double stiffer) {
    double rougher = Math.max(staticFriction, material.staticFriction());
    double ofStiffness = Math.abs(material.stiffnessNewtonPerMm() - stiffness) * (2 + rougher);
    double ofFriction =
        Math.abs(material.staticFriction() - staticFriction)
            + Math.abs(material.slidingFriction() - slidingFriction);
    double maxDamping = Math.max(damping, material.dampingNewtonSecondPerMm());
    double ofDamping =
        maxDamping > 0 ? Math.abs(material.dampingNewtonSecondPerMm() - damping) / maxDamping : 0;
    return stretchMm * (ofStiffness + stiffer * (ofFriction + ofDamping));
  }
}
