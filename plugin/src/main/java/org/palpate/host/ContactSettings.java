package org.palpate.host;

import java.util.Map;
import java.util.OptionalDouble;
import org.palpate.force.ForceSettings;
import org.palpate.force.FrictionForm;
import org.palpate.geometry.Vec3;

/**
 * Settings of contact: solver, collision method, stiffness, friction and limits.
 *
 * <p>Immutable. Start from {@link #standard()}; an empty value means a default.
 *
 * @param solver moves the interaction point
 * @param collision tests paths for collisions; exact if the solver does not let the user choose
 * @param stiffnessNewtonPerMm force per distance between device and interaction point, N per mm of
 *     scan; if empty, the device's default
 * @param friction friction coefficient, 0 or more
 * @param maxStepMm w_max, the longest path of the interaction point in one frame, mm; if empty,
 *     {@link #defaultMaxStepMm}
 * @param maxForceNewton the largest force, N; if empty, the device's maximum
 * @param frictionForm the friction model
 * @param materials overrides of stiffness, friction and damping by the name of a segment
 * @param border how {@link SolverKind#DOT} and {@link SolverKind#PAPER} find border voxels; frames
 *     do not depend on it
 */
public record ContactSettings(
    SolverKind solver,
    CollisionChoice collision,
    OptionalDouble stiffnessNewtonPerMm,
    double friction,
    OptionalDouble maxStepMm,
    OptionalDouble maxForceNewton,
    FrictionForm frictionForm,
    Map<String, MaterialOverride> materials,
    BorderChoice border) {

  /** Copies the map. */
  public ContactSettings {
    materials = Map.copyOf(materials);
  }

  /** Creates settings that find border voxels on the fly. */
  public ContactSettings(
      SolverKind solver,
      CollisionChoice collision,
      OptionalDouble stiffnessNewtonPerMm,
      double friction,
      OptionalDouble maxStepMm,
      OptionalDouble maxForceNewton,
      FrictionForm frictionForm,
      Map<String, MaterialOverride> materials) {
    this(
        solver,
        collision,
        stiffnessNewtonPerMm,
        friction,
        maxStepMm,
        maxForceNewton,
        frictionForm,
        materials,
        BorderChoice.ON_THE_FLY);
  }

  /** Creates settings with friction by the paper's equation (4), the same for all segments. */
  public ContactSettings(
      SolverKind solver,
      CollisionChoice collision,
      OptionalDouble stiffnessNewtonPerMm,
      double friction,
      OptionalDouble maxStepMm,
      OptionalDouble maxForceNewton) {
    this(
        solver,
        collision,
        stiffnessNewtonPerMm,
        friction,
        maxStepMm,
        maxForceNewton,
        FrictionForm.EQUATION_4,
        Map.of());
  }

  /** Returns these settings with another choice of border voxels. */
  public ContactSettings withBorder(BorderChoice newBorder) {
    return new ContactSettings(
        solver,
        collision,
        stiffnessNewtonPerMm,
        friction,
        maxStepMm,
        maxForceNewton,
        frictionForm,
        materials,
        newBorder);
  }

  /** Returns the default settings. */
  public static ContactSettings standard() {
    return standard(SolverKind.DEFAULT);
  }

  /** Returns the default settings for a solver. */
  public static ContactSettings standard(SolverKind solver) {
    return new ContactSettings(
        solver,
        solver.defaultCollision(),
        OptionalDouble.empty(),
        ForceSettings.DEFAULT_FRICTION,
        OptionalDouble.empty(),
        OptionalDouble.empty());
  }

  /**
   * Returns the default of w_max in mm: 8 times the shortest or 3 times the longest voxel edge,
   * whichever is larger.
   */
  public static double defaultMaxStepMm(Vec3 spacingMm) {
    double shortest = Math.min(spacingMm.x, Math.min(spacingMm.y, spacingMm.z));
    double longest = Math.max(spacingMm.x, Math.max(spacingMm.y, spacingMm.z));
    return Math.max(8 * shortest, 3 * longest);
  }
}
