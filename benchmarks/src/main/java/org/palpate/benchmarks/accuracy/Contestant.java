package org.palpate.benchmarks.accuracy;

import java.util.List;
import org.palpate.benchmarks.PlainTwin;
import org.palpate.benchmarks.PlainTwinSolver;
import org.palpate.proxy.BorderVoxels;
import org.palpate.proxy.DotSolver;
import org.palpate.proxy.GuardedSolver;
import org.palpate.proxy.Metric;
import org.palpate.proxy.Obstacles;
import org.palpate.proxy.PaperSolver;
import org.palpate.proxy.ProxySolver;
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
record Contestant(String name, ProxySolver solver, Obstacles obstacles) {
  private static final Metric UNIT = new Metric(1, 1, 1);
  private static final double MAX_STEP_MM = 8;

  /** The yardstick of all times. */
  static final String TWIN = "twin";

  /** Every solver with every collision method, in this scene. */
  static List<Contestant> all(AccuracyScene scene) {
    Obstacles bits = scene.obstacles;
    return List.of(
        new Contestant(TWIN, new PlainTwinSolver(new PlainTwin(scene.bits, MAX_STEP_MM)), bits),
        new Contestant("dot sampled:1", dot(new SampledRayCaster(1)), bits),
        new Contestant("dot exact", dot(new ExactRayCaster()), bits),
        new Contestant("paper sampled:1", paper(new SampledRayCaster(1)), bits),
        new Contestant("paper sampled:0.25", paper(new SampledRayCaster(0.25)), bits),
        new Contestant("paper gridplanes", paper(new GridPlanesRayCaster()), bits),
        new Contestant("paper exact", paper(new ExactRayCaster()), bits),
        new Contestant("guarded", new GuardedSolver(UNIT, MAX_STEP_MM), bits),
        new Contestant("smooth", new SmoothSolver(UNIT, MAX_STEP_MM), bits),
        new Contestant(
            "smooth grey", new SmoothSolver(UNIT, MAX_STEP_MM, scene.grey), scene.greyObstacles));
  }

  private static ProxySolver dot(RayCaster caster) {
    return new DotSolver(caster, UNIT, MAX_STEP_MM, BorderVoxels.onTheFly());
  }

  private static ProxySolver paper(RayCaster caster) {
    return new PaperSolver(caster, UNIT, MAX_STEP_MM, BorderVoxels.onTheFly());
  }
}
