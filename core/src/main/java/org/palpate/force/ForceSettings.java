package org.palpate.force;

import java.util.List;

/**
 * The settings of the contact force: materials and the form of friction.
 *
 * @param general the material of objects that have none of their own
 * @param form the formula of friction
 * @param skipsFriction whether friction is left out if mu is 0 or nothing slid; the force is the
 *     same either way
 * @param materials of the objects, in the order of the scene; empty if all feel alike
 */
public record ForceSettings(
    Material general, FrictionForm form, boolean skipsFriction, List<Material> materials) {

  /** The stiffness for a device without a maximum of its own, N/mm. */
  public static final double DEFAULT_STIFFNESS_NEWTON_PER_MM = 0.5;

  /** The usual mu. */
  public static final double DEFAULT_FRICTION = 0.2;

  /** Copies the list. */
  public ForceSettings {
    materials = List.copyOf(materials);
  }

  /**
   * Makes settings with one material for all objects, without damping.
   *
   * @param stiffnessNewtonPerMm k of every object, N/mm
   * @param friction the static mu of every object
   * @param form the formula of friction
   * @param skipsFriction whether friction is left out if mu is 0 or nothing slid
   */
  public ForceSettings(
      double stiffnessNewtonPerMm, double friction, FrictionForm form, boolean skipsFriction) {
    this(Material.of(stiffnessNewtonPerMm, friction, form), form, skipsFriction, List.of());
  }

  /**
   * {@return settings with friction by equation (4), skipped if it is zero}
   *
   * @param stiffnessNewtonPerMm k of every object, N/mm
   * @param friction the static mu of every object
   */
  public static ForceSettings of(double stiffnessNewtonPerMm, double friction) {
    return new ForceSettings(stiffnessNewtonPerMm, friction, FrictionForm.EQUATION_4, true);
  }

  /** {@return k of objects without a material of their own, N/mm} */
  public double stiffnessNewtonPerMm() {
    return general.stiffnessNewtonPerMm();
  }

  /** {@return the static mu of objects without a material of their own} */
  public double friction() {
    return general.staticFriction();
  }

  /** {@return the largest stiffness of any object, N/mm} */
  public double stiffestNewtonPerMm() {
    double stiffest = stiffnessNewtonPerMm();
    for (Material material : materials) {
      stiffest = Math.max(stiffest, material.stiffnessNewtonPerMm());
    }
    return stiffest;
  }

  /**
   * {@return whether objects have materials of their own, so that the frame must find the touched
   * one}
   */
  public boolean distinguishesObjects() {
    return !materials.isEmpty();
  }

  /**
   * {@return the material of an object, or the general one if the object has none or is unknown}
   *
   * @param object the index of the object in the scene; negative if it is unknown
   */
  public Material material(int object) {
    return object >= 0 && object < materials.size() ? materials.get(object) : general;
  }

  /** {@return whether any material has damping} */
  public boolean damps() {
    boolean damps = general.dampingNewtonSecondPerMm() > 0;
    for (int object = 0; object < materials.size(); object++) {
      damps |= materials.get(object).dampingNewtonSecondPerMm() > 0;
    }
    return damps;
  }

  /**
   * {@return these settings with all stiffnesses multiplied and all frictions increased}
   *
   * @param stiffnessFactor the factor of each stiffness, positive
   * @param addedFriction the increase of each mu
   */
  public ForceSettings retuned(double stiffnessFactor, double addedFriction) {
    Material[] retuned = new Material[materials.size()];
    for (int object = 0; object < retuned.length; object++) {
      retuned[object] = materials.get(object).retuned(stiffnessFactor, addedFriction);
    }
    return new ForceSettings(
        general.retuned(stiffnessFactor, addedFriction), form, skipsFriction, List.of(retuned));
  }
}
