package org.palpate.host;

import java.util.Map;
import java.util.OptionalDouble;
import org.palpate.force.FeelSettings;
import org.palpate.force.ForceSettings;
import org.palpate.force.FrictionForm;
import org.palpate.geometry.Vec3;
import org.palpate.volume.VoxelGrid;

/**
 * Settings of contact: solver, collision method, stiffness, friction and limits.
 *
 * <pre>
 *   ContactSettings.builder(SolverKind.SMOOTH).stiffness(0.8).friction(0.3).build()
 * </pre>
 *
 * <p>Immutable. An empty value means a default.
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
 * @param carveMm3PerNewtonSecond the volume that the tool removes for each N s, mm^3; if empty, it
 *     does not cut
 * @param protectedMm for names of segments the margin around them that nothing cuts, mm
 * @param feel what the hand feels beside plain contact
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
    OptionalDouble carveMm3PerNewtonSecond,
    Map<String, Double> protectedMm,
    FeelSettings feel,
    BorderChoice border) {
  private static final double SMALLEST_USUAL_MM = 32;
  private static final double LARGEST_USUAL_MM = 1000;

  /** Extent of the scan that the smallest scenes feel like, mm. */
  private static final double MODEL_MM = 256;

  /** Exponent of the stiffness against the extent, for scenes just below the usual extents. */
  private static final double GROWTH = 1.5;

  /** Copies the maps. */
  public ContactSettings {
    materials = Map.copyOf(materials);
    protectedMm = Map.copyOf(protectedMm);
  }

  /** {@return the default settings} */
  public static ContactSettings standard() {
    return standard(SolverKind.DEFAULT);
  }

  /**
   * {@return the default settings for a solver}
   *
   * @param solver moves the interaction point
   */
  public static ContactSettings standard(SolverKind solver) {
    return builder(solver).build();
  }

  /**
   * {@return a builder of settings, which starts from the default settings for a solver}
   *
   * @param solver moves the interaction point
   */
  public static Builder builder(SolverKind solver) {
    return new Builder(solver);
  }

  /**
   * {@return the default of w_max in mm: 8 times the shortest or 3 times the longest voxel edge,
   * whichever is larger}
   *
   * @param spacingMm the edges of a voxel, mm
   */
  public static double defaultMaxStepMm(Vec3 spacingMm) {
    double shortest = Math.min(spacingMm.x, Math.min(spacingMm.y, spacingMm.z));
    double longest = Math.max(spacingMm.x, Math.max(spacingMm.y, spacingMm.z));
    return Math.max(8 * shortest, 3 * longest);
  }

  /**
   * {@return the stiffness for a device without a maximum of its own, N per mm of scan}
   *
   * <p>Scenes from 32 mm to 1 m have 0.5 N/mm, and larger ones have less. A hand moves less far in
   * a smaller scene, so its stiffness grows. At 256 um it is 500 N/mm, and each voxel feels as it
   * does in the same scan at 256 mm.
   *
   * @param grid its longest edge is the size of the scene
   */
  public static double defaultStiffnessNewtonPerMm(VoxelGrid grid) {
    Vec3 spacing = grid.spacingMm();
    double extentMm =
        Math.max(
            grid.sizeX() * spacing.x, Math.max(grid.sizeY() * spacing.y, grid.sizeZ() * spacing.z));
    return ForceSettings.DEFAULT_STIFFNESS_NEWTON_PER_MM * stiffnessFactor(extentMm);
  }

  private static double stiffnessFactor(double extentMm) {
    if (extentMm > LARGEST_USUAL_MM) {
      return LARGEST_USUAL_MM / extentMm;
    }
    double smaller = Math.max(1, SMALLEST_USUAL_MM / extentMm);
    return smaller == 1 ? 1 : Math.min(MODEL_MM / extentMm, Math.pow(smaller, GROWTH));
  }

  /** Collects settings; what is not given keeps its default. One thread. */
  public static final class Builder {
    private final SolverKind solver;
    private CollisionChoice collision;
    private OptionalDouble stiffnessNewtonPerMm = OptionalDouble.empty();
    private double friction = ForceSettings.DEFAULT_FRICTION;
    private OptionalDouble maxStepMm = OptionalDouble.empty();
    private OptionalDouble maxForceNewton = OptionalDouble.empty();
    private FrictionForm frictionForm = FrictionForm.EQUATION_4;
    private Map<String, MaterialOverride> materials = Map.of();
    private OptionalDouble carveMm3PerNewtonSecond = OptionalDouble.empty();
    private Map<String, Double> protectedMm = Map.of();
    private FeelSettings feel = FeelSettings.NONE;
    private BorderChoice border = BorderChoice.ON_THE_FLY;

    private Builder(SolverKind solver) {
      this.solver = solver;
      collision = solver.defaultCollision();
    }

    /**
     * Sets the collision method of a solver that lets the user choose.
     *
     * @param method how a path is tested for collisions
     * @return this builder
     */
    public Builder collision(CollisionChoice method) {
      collision = method;
      return this;
    }

    /**
     * Sets the force per distance between device and interaction point.
     *
     * @param newtonPerMm the stiffness, N per mm of scan
     * @return this builder
     */
    public Builder stiffness(double newtonPerMm) {
      return stiffness(OptionalDouble.of(newtonPerMm));
    }

    /**
     * Sets the stiffness.
     *
     * @param newtonPerMm N per mm of scan; empty for the default of scene and device
     * @return this builder
     */
    public Builder stiffness(OptionalDouble newtonPerMm) {
      stiffnessNewtonPerMm = newtonPerMm;
      return this;
    }

    /**
     * Sets the friction coefficient.
     *
     * @param coefficient the static mu, 0 or more
     * @return this builder
     */
    public Builder friction(double coefficient) {
      friction = coefficient;
      return this;
    }

    /**
     * Sets w_max, the longest path of the point in one frame.
     *
     * @param mm the path, mm; empty for {@link #defaultMaxStepMm}
     * @return this builder
     */
    public Builder maxStep(OptionalDouble mm) {
      maxStepMm = mm;
      return this;
    }

    /**
     * Sets the largest force.
     *
     * @param newton the force, N; empty for the device's maximum
     * @return this builder
     */
    public Builder maxForce(OptionalDouble newton) {
      maxForceNewton = newton;
      return this;
    }

    /**
     * Sets the friction model.
     *
     * @param form the formula of friction
     * @return this builder
     */
    public Builder frictionForm(FrictionForm form) {
      frictionForm = form;
      return this;
    }

    /**
     * Sets overrides of stiffness, friction and damping by the name of a segment.
     *
     * @param bySegment the override of each segment that has one, by its name; copied by {@link
     *     #build}
     * @return this builder
     */
    public Builder materials(Map<String, MaterialOverride> bySegment) {
      materials = bySegment;
      return this;
    }

    /**
     * Sets the rate at which the tool cuts.
     *
     * @param mm3PerNewtonSecond the volume removed for each N s, mm^3; empty if the tool does not
     *     cut
     * @return this builder
     */
    public Builder carve(OptionalDouble mm3PerNewtonSecond) {
      carveMm3PerNewtonSecond = mm3PerNewtonSecond;
      return this;
    }

    /**
     * Sets margins around segments that nothing cuts.
     *
     * @param marginsMm the margin of each protected segment by its name, mm; copied by {@link
     *     #build}
     * @return this builder
     */
    public Builder protect(Map<String, Double> marginsMm) {
      protectedMm = marginsMm;
      return this;
    }

    /**
     * Sets what the hand feels beside plain contact.
     *
     * @param chosen effects, mass and grey materials
     * @return this builder
     */
    public Builder feel(FeelSettings chosen) {
      feel = chosen;
      return this;
    }

    /**
     * Sets how the paper's solvers find border voxels.
     *
     * @param choice when they are calculated
     * @return this builder
     */
    public Builder border(BorderChoice choice) {
      border = choice;
      return this;
    }

    /** {@return the settings} */
    public ContactSettings build() {
      return new ContactSettings(
          solver,
          collision,
          stiffnessNewtonPerMm,
          friction,
          maxStepMm,
          maxForceNewton,
          frictionForm,
          materials,
          carveMm3PerNewtonSecond,
          protectedMm,
          feel,
          border);
    }
  }
}
