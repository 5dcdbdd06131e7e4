package org.palpate.benchmarks.stress;

import java.util.List;
import java.util.function.Consumer;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;

/**
 * Drives a solver through case after case until enough frames are done or one fails. Each case
 * comes from the seed and its number alone, so a run goes on from {@link StressTotals} where it
 * ended. One thread.
 */
public final class StressRun {
  private final long seed;
  private final SolverFactory maker;

  /** A run over the cases of a seed. */
  public StressRun(long seed, SolverFactory maker) {
    this.seed = seed;
    this.maker = maker;
  }

  /**
   * Runs whole cases.
   *
   * @param totals what was done before; counted on
   * @param frames until this many are done in all
   * @param afterCase told of the totals after each case
   * @return the first case that failed, made as small as could be, or null
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

  /** As {@link #untilFrames}, by legs. */
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
    FrameJudge judge = new FrameJudge(stress.scene, stress.start, maker);
    ProxySolver solver = maker.make(stress.scene.metric(), stress.scene.maxStepMm());
    CollisionScene obstacles = stress.obstacles();
    InteractionPoint point = new InteractionPoint();
    point.position.set(stress.start);
    Vec3 device = new Vec3().set(stress.start);
    for (int frame = 0; frame < StressCase.ALL_FRAMES; frame++) {
      stress.next(frame, point.position, device);
      solver.follow(obstacles, device, point);
      if (judge.fault(device, point, maker.steps(solver)) != null) {
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
    ProxySolver solver = maker.make(again.scene.metric(), again.scene.maxStepMm());
    List<Vec3> devices = again.devices(solver, frames);
    return new Shrinker(maker).shrink(new FailedCase(again.scene, again.start, devices, caseSeed));
  }

  /** What the case of a number is made from. */
  static long caseSeed(long seed, long number) {
    return seed * 0x9E3779B97F4A7C15L + number;
  }
}
