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
  private double framePart = 1;
  private double stiffness;
  private double staticFriction;
  private double slidingFriction;
  private double damping;

  /** The material that is approached: stiffness, static and sliding friction, and damping. */
  private final double[] wanted = new double[4];

  /** Whether the coupling was stretched in the last frame, so that a new material may be felt. */
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

  /** Begins a frame: its part of the least motion counts. */
  void advance(long elapsedNanos) {
    framePart = FramePart.ofNanos(elapsedNanos);
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

  /**
   * Takes the general material while the tool touches nothing. A tool in hand may be stretched then
   * too, as a needle in tissue or a tool with mass is.
   *
   * @param stretchMm length of the virtual coupling
   * @param motionMm motion of the hand since the last frame
   */
  void release(ForceSettings settings, double stretchMm, double motionMm) {
    approach(settings.general(), stretchMm, motionMm);
    pressed = stretchMm > 0;
  }

  /**
   * Takes the material of a grey value: at once if contact begins, else by a transition.
   *
   * @param grey the value under the contact; not used without contact
   */
  void follow(
      ForceSettings settings,
      GreyMaterials materials,
      double grey,
      boolean contact,
      double stretchMm,
      double motionMm) {
    if (contact) {
      double friction = materials.friction(grey);
      wanted[0] = settings.stiffnessNewtonPerMm() * materials.stiffness(grey);
      wanted[1] = friction;
      wanted[2] = settings.form().slidingFraction() * friction;
      wanted[3] = materials.damping(grey);
      if (pressed) {
        approach(stretchMm, motionMm);
      } else {
        setWanted();
      }
    }
    pressed = stretchMm > 0 && contact;
  }

  /** Takes a material without transition. */
  void set(Material material) {
    want(material);
    setWanted();
  }

  /**
   * Moves towards a material as far as one frame permits.
   *
   * @param stretchMm length of the virtual coupling
   * @param motionMm motion of the hand since the last frame
   */
  void approach(Material material, double stretchMm, double motionMm) {
    want(material);
    approach(stretchMm, motionMm);
  }

  private void want(Material material) {
    wanted[0] = material.stiffnessNewtonPerMm();
    wanted[1] = material.staticFriction();
    wanted[2] = material.slidingFriction();
    wanted[3] = material.dampingNewtonSecondPerMm();
  }

  private void setWanted() {
    stiffness = wanted[0];
    staticFriction = wanted[1];
    slidingFriction = wanted[2];
    damping = wanted[3];
  }

  private void approach(double stretchMm, double motionMm) {
    if (equalsFelt()) {
      return;
    }
    double stiffer = Math.max(stiffness, wanted[0]);
    double maxChange = ChangeBound.ofMotion(stiffer, motionMm, framePart * minMotionMm);
    double change = changeNewton(stretchMm, stiffer);
    if (change <= maxChange) {
      setWanted();
      return;
    }
    double fraction = maxChange / change;
    stiffness += fraction * (wanted[0] - stiffness);
    staticFriction += fraction * (wanted[1] - staticFriction);
    slidingFriction += fraction * (wanted[2] - slidingFriction);
    damping += fraction * (wanted[3] - damping);
  }

  private boolean equalsFelt() {
    return stiffness == wanted[0]
        && staticFriction == wanted[1]
        && slidingFriction == wanted[2]
        && damping == wanted[3];
  }

  /**
   * Returns an upper bound of the change of the force if the material were taken at once, N. It
   * adds up coupling, friction and damping; damping is never longer than the coupling.
   */
  private double changeNewton(double stretchMm, double stiffer) {
    double rougher = Math.max(staticFriction, wanted[1]);
    double ofStiffness = Math.abs(wanted[0] - stiffness) * (2 + rougher);
    double ofFriction =
        Math.abs(wanted[1] - staticFriction) + Math.abs(wanted[2] - slidingFriction);
    double maxDamping = Math.max(damping, wanted[3]);
    double ofDamping = maxDamping > 0 ? Math.abs(wanted[3] - damping) / maxDamping : 0;
    return stretchMm * (ofStiffness + stiffer * (ofFriction + ofDamping));
  }
}
