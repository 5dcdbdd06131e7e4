package org.palpate.proxy.exact;

import org.palpate.geometry.GridMetric;

/** Opens the package-private factory of {@link GuardedSolver} to the benchmarks. */
public final class GuardedSolverVariants {
  private GuardedSolverVariants() {}

  /**
   * Returns a solver that skips only some of its work.
   *
   * @param neighbourhoods whether neighbourhoods are kept from frame to frame
   * @param failedSteps whether searches for a step up that failed are remembered
   * @param rest whether a frame is left out in which the device and the proxy are at rest
   */
  public static GuardedSolver skippingOnly(
      GridMetric metric,
      double maxStepMm,
      boolean neighbourhoods,
      boolean failedSteps,
      boolean rest) {
    return GuardedSolver.skippingOnly(
        new SkipOptions(neighbourhoods, failedSteps, rest), metric, maxStepMm);
  }
}
