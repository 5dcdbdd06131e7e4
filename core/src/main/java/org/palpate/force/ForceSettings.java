package org.palpate.force;

import java.util.List;

/**
 * What surfaces feel like.
 *
 * @param general the material of objects that have none of their own
 * @param form how friction is computed
 * @param skipsFriction whether friction is left out where mu is 0 or nothing slid; the force is the
 *     same either way
 * @param materials of the objects, in the order of the obstacles; empty where all feel alike
 */
public record ForceSettings(
    Material general, FrictionForm form, boolean skipsFriction, List<Material> materials) {

  /** Stiffness for a device that has no maximum of its own, N/mm. */
  public static final double DEFAULT_STIFFNESS_NEWTON_PER_MM = 0.5;

  public static final double DEFAULT_FRICTION = 0.2;

  /** Keeps a copy of the list. */
  public ForceSettings {
    materials = List.copyOf(materials);
  }

  /** One material for all, without damping. */
  public ForceSettings(
      double stiffnessNewtonPerMm, double friction, FrictionForm form, boolean skipsFriction) {
    this(Material.of(stiffnessNewtonPerMm, friction, form), form, skipsFriction, List.of());
  }

  /** By equation (4), with friction skipped where it is nothing. */
  public static ForceSettings of(double stiffnessNewtonPerMm, double friction) {
    return new ForceSettings(stiffnessNewtonPerMm, friction, FrictionForm.EQUATION_4, true);
  }

  /** k of objects without a material of their own, N/mm. */
  public double stiffnessNewtonPerMm() {
    return general.stiffnessNewtonPerMm();
  }

  /** mu of objects without a material of their own. */
  public double friction() {
    return general.stickingFriction();
  }

  /** The largest stiffness of any object, N/mm. */
  public double stiffestNewtonPerMm() {
    double stiffest = stiffnessNewtonPerMm();
    for (Material material : materials) {
      stiffest = Math.max(stiffest, material.stiffnessNewtonPerMm());
    }
    return stiffest;
  }

  /** Whether objects differ, so that one has to know which is touched. */
  public boolean tellsObjectsApart() {
    return !materials.isEmpty();
  }

  /** The material of an object; the general one where it is not known or has none. */
  public Material material(int object) {
    return object >= 0 && object < materials.size() ? materials.get(object) : general;
  }

  /** Whether anything is damped. */
  public boolean damps() {
    boolean damps = general.dampingNewtonSecondPerMm() > 0;
    for (int object = 0; object < materials.size(); object++) {
      damps |= materials.get(object).dampingNewtonSecondPerMm() > 0;
    }
    return damps;
  }

  /** The same objects, all stiffer by a factor and rougher by a summand. */
  public ForceSettings retuned(double stiffnessFactor, double moreFriction) {
    Material[] retuned = new Material[materials.size()];
    for (int object = 0; object < retuned.length; object++) {
      retuned[object] = materials.get(object).retuned(stiffnessFactor, moreFriction);
    }
    return new ForceSettings(
        general.retuned(stiffnessFactor, moreFriction), form, skipsFriction, List.of(retuned));
  }
}
