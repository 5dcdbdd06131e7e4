package org.palpate.force;

/**
 * The material that is felt: where contact passes from one object to another it goes over from the
 * one's to the other's, all four figures in step, so that on its account the force changes in one
 * frame by at most k times the larger of the hand's motion and {@link #LEAST_MOTION_EDGES}, k the
 * larger stiffness of the two. Haptic thread; allocates nothing.
 */
final class MaterialTransition {
  /** In shortest voxel edges: a hand at rest feels the change arrive too. */
  static final double LEAST_MOTION_EDGES = 0.05;

  private final double leastMotionMm;
  private double stiffness;
  private double sticking;
  private double sliding;
  private double damping;

  MaterialTransition(double shortestEdgeMm, Material first) {
    leastMotionMm = LEAST_MOTION_EDGES * shortestEdgeMm;
    set(first);
  }

  double stiffnessNewtonPerMm() {
    return stiffness;
  }

  double stickingFriction() {
    return sticking;
  }

  double slidingFriction() {
    return sliding;
  }

  double dampingNewtonSecondPerMm() {
    return damping;
  }

  /** Takes a material as it is. */
  void set(Material material) {
    stiffness = material.stiffnessNewtonPerMm();
    sticking = material.stickingFriction();
    sliding = material.slidingFriction();
    damping = material.dampingNewtonSecondPerMm();
  }

  /**
   * Goes towards a material as far as a frame may.
   *
   * @param stretchMm length of the virtual coupling
   * @param motionMm how far the hand went since the last frame
   */
  void approach(Material material, double stretchMm, double motionMm) {
    if (isThere(material)) {
      return;
    }
    double stiffer = Math.max(stiffness, material.stiffnessNewtonPerMm());
    double most = stiffer * Math.max(motionMm, leastMotionMm);
    double change = changeNewton(material, stretchMm, stiffer);
    if (change <= most) {
      set(material);
      return;
    }
    double share = most / change;
    stiffness += share * (material.stiffnessNewtonPerMm() - stiffness);
    sticking += share * (material.stickingFriction() - sticking);
    sliding += share * (material.slidingFriction() - sliding);
    damping += share * (material.dampingNewtonSecondPerMm() - damping);
  }

  private boolean isThere(Material material) {
    return stiffness == material.stiffnessNewtonPerMm()
        && sticking == material.stickingFriction()
        && sliding == material.slidingFriction()
        && damping == material.dampingNewtonSecondPerMm();
  }

  /**
   * A bound of how much the force would change: of coupling, of damping, which is less, friction.
   */
  private double changeNewton(Material material, double stretchMm, double stiffer) {
    double rougher = Math.max(sticking, material.stickingFriction());
    double ofStiffness = Math.abs(material.stiffnessNewtonPerMm() - stiffness) * (2 + rougher);
    double unlike =
        Math.abs(material.stickingFriction() - sticking)
            + Math.abs(material.slidingFriction() - sliding);
    double dampingMost = Math.max(damping, material.dampingNewtonSecondPerMm());
    double ofDamping =
        dampingMost > 0 ? Math.abs(material.dampingNewtonSecondPerMm() - damping) / dampingMost : 0;
    return stretchMm * (ofStiffness + stiffer * (unlike + ofDamping));
  }
}
