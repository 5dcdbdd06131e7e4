package org.palpate.benchmarks.stress;

import java.util.List;
import java.util.function.Consumer;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;

/**
 * Runs a solver on one case after the other until enough frames are done or one fails. A case
 * depends only on the seed and its number, so that a run continues from {@link StressTotals}. One
 * thread.
 */
public final class StressRun {
  private final long seed;
  private final SolverFactory factory;

  /** Creates a run over the cases of a seed. */
  public StressRun(long seed, SolverFactory factory) {
    this.seed = seed;
    this.factory = factory;
  }

  /**
   * Runs whole cases until a total number of frames is reached.
   *
   * @param totals the totals so far, which are increased
   * @param frames the total number of frames
   * @param afterCase receives the totals after each case
   * @return the first failed case, shrunk, or null
   */
  public FailedCase untilFrames(
      StressTotals totals, long frames, Consumer<StressTotals> afterCase) {
    while (totals.frames < frames) {
      FailedCase failed = runCase(totals);
      if (failed != null) {
        return failed;
      }
      afterCase.accept(totals);
    }
    return null;
  }

  /** Runs whole cases until a total number of legs is reached; see {@link #untilFrames}. */
  public FailedCase untilLegs(StressTotals totals, long legs, Consumer<StressTotals> afterCase) {
    while (totals.legs < legs) {
      FailedCase failed = runCase(totals);
      if (failed != null) {
        return failed;
      }
      afterCase.accept(totals);
    }
    return null;
  }

  private FailedCase runCase(StressTotals totals) {
    long caseSeed = caseSeed(seed, totals.cases);
    StressCase stress = new StressCase(caseSeed);
    FrameJudge judge = new FrameJudge(stress.scene, stress.start, factory);
    ProxySolver solver = factory.make(stress.scene.metric(), stress.scene.maxStepMm());
    CollisionScene collisionScene = stress.collisionScene();
    InteractionPoint point = new InteractionPoint();
    point.position.set(stress.start);
    Vec3 device = new Vec3().set(stress.start);
    for (int frame = 0; frame < StressCase.ALL_FRAMES; frame++) {
      stress.next(frame, point.position, device);
      solver.follow(collisionScene, device, point);
      if (judge.fault(device, point, factory.steps(solver)) != null) {
        return failed(caseSeed, frame + 1);
      }
    }
    totals.cases++;
    totals.frames += StressCase.ALL_FRAMES;
    totals.legs += judge.legs();
    totals.exactDecisions += judge.exactDecisions();
    return null;
  }

  private FailedCase failed(long caseSeed, int frames) {
    StressCase again = new StressCase(caseSeed);
    ProxySolver solver = factory.make(again.scene.metric(), again.scene.maxStepMm());
    List<Vec3> devices = again.devices(solver, frames);
    return new Shrinker(factory)
        .shrink(new FailedCase(again.scene, again.start, devices, caseSeed));
  }

  /** Returns the seed of the case with a number. */
  static long caseSeed(long seed, long number) {
    return seed * 0x9E3779B97F4A7C15L + number;
  }
}
