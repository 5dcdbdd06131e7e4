package org.palpate.benchmarks.accuracy;

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
 * @param name with its collision method
 * @param solver made for the scene
 * @param obstacles what it touches
 */
record ComparedSolver(String name, ProxySolver solver, CollisionScene obstacles) {
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);
  private static final double MAX_STEP_MM = 8;

  /** The yardstick of all times. */
  static final String BASELINE = "twin";

  /** Every solver with every collision method, in this scene. */
  static List<ComparedSolver> all(AccuracyScene scene) {
    CollisionScene bits = scene.obstacles;
    return List.of(
        new ComparedSolver(
            BASELINE, new PlainBaselineSolver(new PlainBaseline(scene.bits, MAX_STEP_MM)), bits),
        new ComparedSolver("dot sampled:1", dot(new SampledRayCaster(1)), bits),
        new ComparedSolver("dot exact", dot(new ExactRayCaster()), bits),
        new ComparedSolver("paper sampled:1", paper(new SampledRayCaster(1)), bits),
        new ComparedSolver("paper sampled:0.25", paper(new SampledRayCaster(0.25)), bits),
        new ComparedSolver("paper gridplanes", paper(new GridPlanesRayCaster()), bits),
        new ComparedSolver("paper exact", paper(new ExactRayCaster()), bits),
        new ComparedSolver("guarded", new GuardedSolver(UNIT, MAX_STEP_MM), bits),
        new ComparedSolver("smooth", new SmoothSolver(UNIT, MAX_STEP_MM), bits),
        new ComparedSolver(
            "smooth grey", new SmoothSolver(UNIT, MAX_STEP_MM, scene.grey), scene.greyObstacles));
  }

  private static ProxySolver dot(RayCaster caster) {
    return new DotSolver(caster, UNIT, MAX_STEP_MM, BorderVoxels.onTheFly());
  }

  private static ProxySolver paper(RayCaster caster) {
    return new PaperSolver(caster, UNIT, MAX_STEP_MM, BorderVoxels.onTheFly());
  }
}
