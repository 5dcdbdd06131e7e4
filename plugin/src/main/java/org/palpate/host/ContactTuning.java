package org.palpate.host;

import java.util.List;
import org.palpate.device.DeviceSpecification;
import org.palpate.force.ForceSettings;
import org.palpate.frame.HapticFrame;

/**
 * What surfaces feel like, changed in steps while they are touched: stiffness and friction of all
 * segments together, solver. Each change is felt from the next frame on. Any thread.
 */
public final class ContactTuning {
  private static final double STIFFNESS_STEP = 1.25;
  private static final double LEAST_NEWTON_PER_MM = 0.01;

  /** For devices that tell no maximum. */
  private static final double LARGEST_NEWTON_PER_MM = 10;

  private static final double FRICTION_STEP = 0.05;
  private static final double LARGEST_FRICTION = 1;

  /** In the order in which {@link #nextSolver} goes through them. */
  private static final List<SolverKind> SOLVERS =
      List.of(SolverKind.SMOOTH, SolverKind.GUARDED, SolverKind.PAPER, SolverKind.DOT);

  private final HapticFrame frame;
  private final ContactScene scene;
  private final double mostNewtonPerMm;
  private ForceSettings force;
  private SolverKind solver;

  /** Begins with what the frame was made with. */
  ContactTuning(
      HapticFrame frame, ContactScene scene, ForceSettings force, DeviceSpecification device) {
    this.frame = frame;
    this.scene = scene;
    this.force = force;
    solver = scene.settings().solver();
    double most = device.maxStiffnessNewtonPerMm();
    boolean told = most > 0 && !Double.isInfinite(most);
    mostNewtonPerMm = Math.max(told ? most : LARGEST_NEWTON_PER_MM, force.stiffestNewtonPerMm());
  }

  /** A quarter stiffer, until the stiffest segment reaches the device's maximum. */
  public synchronized void stiffer() {
    makeStiffer(STIFFNESS_STEP);
  }

  /** The step of {@link #stiffer} back. */
  public synchronized void softer() {
    makeStiffer(1 / STIFFNESS_STEP);
  }

  private void makeStiffer(double factor) {
    double stiffest = force.stiffestNewtonPerMm();
    double within = Math.max(LEAST_NEWTON_PER_MM, Math.min(mostNewtonPerMm, factor * stiffest));
    retune(stiffest > 0 ? within / stiffest : 1, 0);
  }

  /** More friction by 0.05, up to 1. */
  public synchronized void rougher() {
    setFriction(force.friction() + FRICTION_STEP);
  }

  /** Less friction by 0.05, down to none. */
  public synchronized void decreaseFriction() {
    setFriction(force.friction() - FRICTION_STEP);
  }

  private void setFriction(double friction) {
    double steps = Math.rint(friction / FRICTION_STEP) * FRICTION_STEP;
    retune(1, Math.max(0, Math.min(LARGEST_FRICTION, steps)) - force.friction());
  }

  private void retune(double stiffnessFactor, double moreFriction) {
    force = force.retuned(stiffnessFactor, moreFriction);
    frame.requestForce(force);
  }

  /** The next of smooth, guarded, paper and dot; the last two do not keep the guarantee. */
  public synchronized void nextSolver() {
    solver = SOLVERS.get((SOLVERS.indexOf(solver) + 1) % SOLVERS.size());
    frame.requestSolver(scene.newSolver(solver));
  }

  /** The solver that the next frame runs. */
  public synchronized SolverKind solver() {
    return solver;
  }

  /** Stiffness and friction of the next frame. */
  public synchronized ForceSettings force() {
    return force;
  }
}
