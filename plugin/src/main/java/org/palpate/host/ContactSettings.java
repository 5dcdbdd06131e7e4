package org.palpate.host;

import java.util.Map;
import java.util.OptionalDouble;
import org.palpate.force.ForceSettings;
import org.palpate.force.FrictionForm;
import org.palpate.geometry.Vec3;

/**
 * How touching is to be done.
 *
 * @param solver what moves the interaction point
 * @param collision how collisions are found; exact where the solver does not let one choose
 * @param stiffnessNewtonPerMm force over distance, of scan; the device's own default where empty
 * @param friction coefficient, 0 or more
 * @param maxStepMm w_max, the most that the point travels in a frame; {@link #defaultMaxStepMm}
 *     where empty
 * @param maxForceNewton the largest force; the device's maximum where empty
 * @param frictionForm how friction is computed
 * @param materials by the name of a segment: what differs from all of this
 */
public record ContactSettings(
    SolverKind solver,
    CollisionChoice collision,
    OptionalDouble stiffnessNewtonPerMm,
    double friction,
    OptionalDouble maxStepMm,
    OptionalDouble maxForceNewton,
    FrictionForm frictionForm,
    Map<String, MaterialOverride> materials) {

  /** Keeps a copy of the map. */
  public ContactSettings {
    materials = Map.copyOf(materials);
  }

  /** With friction by the paper's equation (4), the same for all segments. */
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

  /** Everything as it is unless one says otherwise. */
  public static ContactSettings standard() {
    return standard(SolverKind.DEFAULT);
  }

  /** A solver with everything else as it is unless one says otherwise. */
  public static ContactSettings standard(SolverKind solver) {
    return new ContactSettings(
        solver,
        solver.defaultCollision(),
        OptionalDouble.empty(),
        ForceSettings.DEFAULT_FRICTION,
        OptionalDouble.empty(),
        OptionalDouble.empty());
  }

  /** The larger of 8 shortest and 3 longest voxel edges, mm. */
  public static double defaultMaxStepMm(Vec3 spacingMm) {
    double shortest = Math.min(spacingMm.x, Math.min(spacingMm.y, spacingMm.z));
    double longest = Math.max(spacingMm.x, Math.max(spacingMm.y, spacingMm.z));
    return Math.max(8 * shortest, 3 * longest);
  }
}
