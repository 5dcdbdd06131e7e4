package org.palpate.benchmarks.accuracy;

import java.util.ArrayList;
import java.util.List;
import org.palpate.benchmarks.baseline.PlainBaseline;
import org.palpate.benchmarks.baseline.PlainBaselineSolver;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.reference.BorderVoxels;
import org.palpate.proxy.reference.DotSolver;
import org.palpate.proxy.reference.PaperSolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.GridPlanesRayCaster;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.SampledRayCaster;

/**
 * A solver in a scene.
 *
 * @param name the solver with its collision method
 * @param solver a solver made for the scene
 * @param scene the solids that it touches
 */
record ComparedSolver(String name, ProxySolver solver, CollisionScene scene) {
  private static final double MAX_STEP_MM = 8;

  /** The name of the plain baseline, to which all times are relative. */
  static final String BASELINE = "twin";

  /** Returns every solver with every collision method. */
  static List<ComparedSolver> all(AccuracyScene scene) {
    CollisionScene bits = scene.collisionScene;
    GridMetric metric = scene.metric;
    List<ComparedSolver> ours = ours(scene);
    List<ComparedSolver> solvers = new ArrayList<>();
    solvers.add(ours.get(0));
    solvers.add(new ComparedSolver("dot sampled:1", dot(new SampledRayCaster(1), metric), bits));
    solvers.add(new ComparedSolver("dot exact", dot(new ExactRayCaster(), metric), bits));
    solvers.add(
        new ComparedSolver("paper sampled:1", paper(new SampledRayCaster(1), metric), bits));
    solvers.add(
        new ComparedSolver("paper sampled:0.25", paper(new SampledRayCaster(0.25), metric), bits));
    solvers.add(
        new ComparedSolver("paper gridplanes", paper(new GridPlanesRayCaster(), metric), bits));
    solvers.add(new ComparedSolver("paper exact", paper(new ExactRayCaster(), metric), bits));
    solvers.addAll(ours.subList(1, ours.size()));
    return solvers;
  }

  /** Returns the plain baseline and the solvers that keep the guarantee. */
  static List<ComparedSolver> ours(AccuracyScene scene) {
    CollisionScene bits = scene.collisionScene;
    GridMetric metric = scene.metric;
    return List.of(
        new ComparedSolver(
            BASELINE, new PlainBaselineSolver(new PlainBaseline(scene.bits, MAX_STEP_MM)), bits),
        new ComparedSolver("guarded", new GuardedSolver(metric, MAX_STEP_MM), bits),
        new ComparedSolver("smooth", new SmoothSolver(metric, MAX_STEP_MM), bits),
        new ComparedSolver(
            "smooth grey",
            new SmoothSolver(metric, MAX_STEP_MM, scene.grey),
            scene.greyCollisionScene));
  }

  private static ProxySolver dot(RayCaster caster, GridMetric metric) {
    return new DotSolver(caster, metric, MAX_STEP_MM, BorderVoxels.onTheFly());
  }

  private static ProxySolver paper(RayCaster caster, GridMetric metric) {
    return new PaperSolver(caster, metric, MAX_STEP_MM, BorderVoxels.onTheFly());
  }
}
