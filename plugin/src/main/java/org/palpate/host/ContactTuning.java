package org.palpate.host;

import static java.util.stream.Collectors.joining;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import org.palpate.device.DeviceSpecification;
import org.palpate.force.ForceSettings;
import org.palpate.frame.PointFrame;
import org.palpate.frame.ToolFrame;

/**
 * Changes stiffness, friction and the solver in steps while the user touches. Each change takes
 * effect in the next frame and applies to all segments together. Any thread.
 */
public final class ContactTuning {
  private static final double STIFFNESS_STEP = 1.25;
  private static final double MIN_NEWTON_PER_MM = 0.01;

  /** The maximum for devices that report none. */
  private static final double DEFAULT_MAX_NEWTON_PER_MM = 10;

  private static final double FRICTION_STEP = 0.05;
  private static final double MAX_FRICTION = 1;

  /** In the order of {@link #nextSolver}. */
  private static final List<SolverKind> SOLVERS =
      List.of(SolverKind.SMOOTH, SolverKind.GUARDED, SolverKind.PAPER, SolverKind.DOT);

  /** Those that move an interaction point among elastic segments. */
  private static final List<SolverKind> SOLVERS_OF_ELASTIC =
      SOLVERS.stream().filter(SolverKind::keepsGuarantee).toList();

  private static final String RIGID_TOOL = "rigid tool";

  private final Consumer<ForceSettings> forceRequests;
  private final Consumer<SolverKind> solverRequests;
  private final List<SolverKind> solvers;
  private final double maxNewtonPerMm;
  private ForceSettings force;

  /** Null for a rigid tool, which has one solver. */
  private SolverKind solver;

  /**
   * Starts from the settings that the frame was created with.
   *
   * @param elastic whether segments are elastic
   */
  ContactTuning(
      PointFrame frame,
      ContactScene scene,
      ForceSettings force,
      DeviceSpecification device,
      boolean elastic) {
    this(
        frame::requestForce,
        kind -> frame.requestSolver(scene.newSolver(kind)),
        elastic ? SOLVERS_OF_ELASTIC : SOLVERS,
        scene.settings().solver(),
        force,
        device);
  }

  /**
   * Returns the tuning of a rigid tool, which changes its stiffness in translation and rotation
   * together. Requests to change the solver do nothing.
   */
  static ContactTuning ofTool(ToolFrame frame, ForceSettings force, DeviceSpecification device) {
    return new ContactTuning(frame::requestForce, kind -> {}, List.of(), null, force, device);
  }

  private ContactTuning(
      Consumer<ForceSettings> forceRequests,
      Consumer<SolverKind> solverRequests,
      List<SolverKind> solvers,
      SolverKind solver,
      ForceSettings force,
      DeviceSpecification device) {
    this.forceRequests = forceRequests;
    this.solverRequests = solverRequests;
    this.solvers = solvers;
    this.solver = solver;
    this.force = force;
    double deviceMax = device.maxStiffnessNewtonPerMm();
    boolean isKnown = deviceMax > 0 && !Double.isInfinite(deviceMax);
    maxNewtonPerMm =
        Math.max(isKnown ? deviceMax : DEFAULT_MAX_NEWTON_PER_MM, force.stiffestNewtonPerMm());
  }

  /**
   * Increases the stiffness by a quarter, until the stiffest segment reaches the device's maximum.
   */
  public synchronized void increaseStiffness() {
    scaleStiffness(STIFFNESS_STEP);
  }

  /** Decreases the stiffness by the step of {@link #increaseStiffness}. */
  public synchronized void decreaseStiffness() {
    scaleStiffness(1 / STIFFNESS_STEP);
  }

  private void scaleStiffness(double factor) {
    double stiffest = force.stiffestNewtonPerMm();
    double limited = Math.max(MIN_NEWTON_PER_MM, Math.min(maxNewtonPerMm, factor * stiffest));
    retune(stiffest > 0 ? limited / stiffest : 1, 0);
  }

  /** Increases the friction coefficient by 0.05, up to 1. */
  public synchronized void increaseFriction() {
    changeFriction(force.friction() + FRICTION_STEP);
  }

  /** Decreases the friction coefficient by 0.05, down to 0. */
  public synchronized void decreaseFriction() {
    changeFriction(force.friction() - FRICTION_STEP);
  }

  private void changeFriction(double friction) {
    double steps = Math.rint(friction / FRICTION_STEP) * FRICTION_STEP;
    retune(1, Math.max(0, Math.min(MAX_FRICTION, steps)) - force.friction());
  }

  private void retune(double stiffnessFactor, double addedFriction) {
    force = force.retuned(stiffnessFactor, addedFriction);
    forceRequests.accept(force);
  }

  /**
   * Switches to the next of smooth, guarded, paper and dot. The last two do not keep the guarantee,
   * and are left out if segments are elastic.
   */
  public synchronized void nextSolver() {
    if (solver != null) {
      solver = solvers.get((solvers.indexOf(solver) + 1) % solvers.size());
      solverRequests.accept(solver);
    }
  }

  /** Returns what {@link #nextSolver} does, for the help of its key; empty for a rigid tool. */
  Optional<String> solverHelp() {
    return solvers.isEmpty()
        ? Optional.empty()
        : Optional.of(
            solvers.stream().map(SolverKind::toString).collect(joining(", ", "next solver: ", "")));
  }

  /** {@return the kind of solver that the next frame runs; empty for a rigid tool} */
  public synchronized Optional<SolverKind> solver() {
    return Optional.ofNullable(solver);
  }

  /** {@return one line for the user: solver, stiffness and friction of the next frame} */
  public synchronized String line() {
    return String.format(
        Locale.ROOT,
        "%s   %.2f N/mm   friction %.2f",
        solver == null ? RIGID_TOOL : solver,
        force.stiffnessNewtonPerMm(),
        force.friction());
  }

  /** {@return stiffness and friction of the next frame} */
  public synchronized ForceSettings force() {
    return force;
  }
}
